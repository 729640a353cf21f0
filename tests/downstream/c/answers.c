#include "cases.h"
#include <cell/cell.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The structs of the header hold their numbers side by side. */
#define TAKE(type, name)                                                                                               \
  type name;                                                                                                           \
  do {                                                                                                                 \
    float numbers[sizeof(type) / sizeof(float)];                                                                       \
    fill(numbers, (int)(sizeof numbers / sizeof *numbers));                                                            \
    memcpy(&name, numbers, sizeof name);                                                                               \
  } while (0)

int main(void) {
  for (int i = 0; i < cases; ++i) {
    TAKE(cell_trianglef, A);
    TAKE(cell_trianglef, B);
    TAKE(cell_segmentf, s);
    TAKE(cell_spheref, S);
    TAKE(cell_linef, L);
    S.r = fabsf(S.r);
    const cell_sphere Sd = {{S.c.x, S.c.y, S.c.z}, S.r};
    const cell_line Ld = {{L.p.x, L.p.y, L.p.z}, {L.q.x, L.q.y, L.q.z}};
    const cell_point_pair_bladef b = cell_meet_sphere_linef(&S, &L);
    printf("%a %a %a %a ", (double)b.e1_n, (double)b.e2_e3, (double)cell_norm2_meet_sphere_linef(&S, &L),
           cell_norm2_meet_sphere_line(&Sd, &Ld));
    printf("%d%d%d%d ", cell_side_triangle_point_fp32(&A, &B.a), cell_side_triangle_point_fp64(&A, &B.a),
           cell_side_triangle_point_fp64x2(&A, &B.a), cell_side_triangle_point(&A, &B.a));
    printf("%d%d%d%d%d ", cell_segment_triangle_fp32(&s, &A), cell_segment_triangle_fp64(&s, &A),
           cell_segment_triangle_fp64x2(&s, &A), cell_segment_triangle(&s, &A), cell_segment_triangle_filter(&s, &A));
    printf("%d%d%d%d%d ", cell_triangle_triangle_fp32(&A, &B), cell_triangle_triangle_fp64(&A, &B),
           cell_triangle_triangle_fp64x2(&A, &B), cell_triangle_triangle(&A, &B),
           cell_triangle_triangle_filter(&A, &B));
    printf("%d%d%d%d%d %d\n", cell_ball_triangle_fp32(&S, &A), cell_ball_triangle_fp64(&S, &A),
           cell_ball_triangle_fp64x2(&S, &A), cell_ball_triangle(&S, &A), cell_ball_triangle_filter(&S, &A),
           cell_valid_sphere(&S));
  }
  return 0;
}
