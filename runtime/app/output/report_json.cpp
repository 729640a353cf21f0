// The answer of `meet collide` as JSON.
#include "meet/app/output/report.hpp"
#include "meet/app/text/json.hpp"

namespace meetc::app {

namespace {

json side(const io::element_set &set) {
  return {{"kind", set.kind->name}, {"elements", set.items}};
}

// In the order in which the rungs run; empty for a plain rung.
json unsure(const collide_report &r) {
  json out = json::object();
  for (int i = 0; i < bounded_rungs && r.asked.precision == rung::certified; ++i)
    out[name_of(static_cast<rung>(i))] = r.found.rungs.unsure[i];
  return out;
}

// The numbers of both files that reading moved; those of one file that is given twice count once.
json rounded(const collide_report &r) {
  io::rounded_numbers all = r.a.rounded;
  if (&r.a != &r.b)
    all.add(r.b.rounded);
  return {{"numbers", all.numbers}, {"largest", all.largest}};
}

json seconds(const collide_report &r) {
  const answers &f = r.found;
  json out = {{"read", with_decimals(r.read_seconds, 6)},
              {"prepare", with_decimals(f.prepare_seconds, 6)},
              {"collide", with_decimals(f.collide_seconds, 6)}};
  if (r.contacts)
    out["contacts"] = with_decimals(r.contacts->seconds, 6);
  if (r.found.on == processor::cuda) {
    out["start"] = with_decimals(f.by_device.start_seconds, 6);
    out["device"] = with_decimals(f.by_device.device_seconds, 6);
  }
  return out;
}

} // namespace

std::string as_json(const collide_report &r) {
  const answers &f = r.found;
  const bool on_device = r.found.on == processor::cuda;
  json out = {{"a", side(r.a)},
              {"b", side(r.b)},
              {"pairs", f.pairs},
              {"touched_a", f.a.touched},
              {"touched_b", f.b.touched},
              {"rounded", rounded(r)},
              {"precision", name_of(r.asked.precision)},
              {"device", on_device ? "cuda" : "cpu"},
              {"unsure", unsure(r)},
              {"seconds", seconds(r)},
              {"predicate", r.asked.by.predicate->name},
              {"mode", r.asked.by.predicate->mode}};
  if (const auto &c = r.contacts)
    out["contacts"] = {{"nodes", c->nodes},         {"pieces", c->pieces},
                       {"polylines", c->polylines}, {"closed", c->closed},
                       {"patches", c->patches},     {"single_nodes", c->single_nodes},
                       {"witnesses", c->witnesses}, {"embedded", name_of(c->embedded)}};
  if (r.asked.tolerance > 0) {
    out["tolerance"] = r.asked.tolerance;
    out["grid"] = r.asked.grid;
  }
  if (!on_device)
    out["instruction_set"] = r.instruction_set;
  if (on_device) {
    out["device_name"] = f.by_device.device;
    out["devices"] = f.by_device.devices;
  }
  if (const std::vector<std::string> notes = all_notes(r); !notes.empty())
    out["notes"] = notes;
  return in_one_line(out) + '\n';
}

} // namespace meetc::app
