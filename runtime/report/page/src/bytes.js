// The arrays of a report, as runtime/report/bytes.hpp writes them.
async function inflate(base64) {
  const text = atob(base64);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class Arrays {
  constructor(bytes) {
    this.all = bytes;
  }
  static async of(base64) {
    return new Arrays(await inflate(base64));
  }

  bytes([begin, length]) {
    return this.all.subarray(begin, begin + length);
  }
  varints(extent) {
    const from = this.bytes(extent);
    let n = 0;
    for (const byte of from) n += byte < 128;
    const out = new Uint32Array(n);
    for (let i = 0, at = 0; i < n; ++i) {
      let value = 0, shift = 0, byte;
      do {
        byte = from[at++];
        value |= (byte & 127) << shift;
        shift += 7;
      } while (byte > 127);
      out[i] = value;
    }
    return out;
  }
  differences(extent) {
    const out = this.varints(extent);
    for (let i = 0, last = 0; i < out.length; ++i) out[i] = last = last + ((out[i] >>> 1) ^ -(out[i] & 1));
    return out;
  }
  corners(extent) {
    const out = this.varints(extent);
    for (let i = 0, next = 0; i < out.length; ++i) {
      out[i] = next - out[i];
      if (out[i] === next) ++next;
    }
    return out;
  }
  floats(extent) {
    const from = this.bytes(extent), n = from.length / 4;
    const to = new Uint8Array(from.length);
    for (let plane = 0; plane < 4; ++plane)
      for (let i = 0; i < n; ++i) to[4 * i + plane] = from[plane * n + i];
    return new Float32Array(to.buffer);
  }
  // The numbers of n points, three each, of 16 bits.
  points(extent, n) {
    const from = this.bytes(extent), out = new Uint16Array(3 * n);
    for (let axis = 0; axis < 3; ++axis) {
      const low = 2 * axis * n, high = low + n;
      for (let i = 0, last = 0; i < n; ++i) {
        const coded = from[low + i] | (from[high + i] << 8);
        last = (last + ((coded >>> 1) ^ -(coded & 1))) & 0xffff;
        out[3 * i + axis] = last;
      }
    }
    return out;
  }
}
