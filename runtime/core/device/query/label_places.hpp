// core/device/query/label_places.hpp: the coordinates of nodes where pairs meet. The kernel knows no shapes but numbers of
// corners; it is only enqueued.
#ifndef MEETC_CORE_DEVICE_QUERY_LABEL_PLACES_HPP
#define MEETC_CORE_DEVICE_QUERY_LABEL_PLACES_HPP

#include "meet/core/contacts/contacts.hpp"

#include <cuda_runtime_api.h>

namespace meetc::on_device {

struct place_job {
  const float *a, *b;       // rows
  int corners_a, corners_b; // of an element
  const node_source *nodes; // rows and labels
  std::size_t count;
};
// points: x, y, z of each node, as place_label() rounds them; NaN where only integers tell a coordinate
// (meetc/contact/place.hpp).
cudaError_t place_labels(const place_job &job, float *points, cudaStream_t stream);
cudaError_t place_labels(const place_job &job, double *points, cudaStream_t stream);

} // namespace meetc::on_device

#endif
