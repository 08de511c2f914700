/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/wall: a rigid wall with friction, at rest, moving or under a load.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/wall,FixTMSPHWall);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_WALL_H
#define LMP_FIX_TMSPH_WALL_H

#include "fix_tmsph_bond.h"
#include "tmsph_contact_law.h"
#include "tmsph_presses.h"
#include "tmsph_rigid_motion.h"
#include "tmsph_wall_shape.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHWall : public Fix, public TMSPHPresses, public TMSPHStoresIds {
 public:
  FixTMSPHWall(class LAMMPS *, int, char **);
  ~FixTMSPHWall() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  bool has_ids() const override { return !memories.empty(); }
  void add_shares(std::vector<Share> &) override;
  bool may_press() const override;
  int image(int *&, double **&) override;

  /// lines of two points in 2-D, triangles in 3-D, where the wall is now
  std::vector<std::vector<TMSPH::Point>> pieces() const;

  /// moves a wall over a time to the present step, with its prescribed velocities
  void move(double duration);
  /// of the fastest particle near it, if that went along
  double speed() const;
  bool loaded() const { return mass > 0.0; }

  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:
  using Point = TMSPH::Point;

  /// how far behind the surface a centre is still held, in half cells
  static constexpr double REACH = 2.0;

  /** Where friction is zero, in the coordinates of the wall at the start. */
  struct Anchor {
    int piece;
    Point point;
  };
  /** What a touching particle remembers of its last step. */
  struct Memory {
    double force[3] = {};
    std::uint64_t stamp = 0;                   // fingerprint at the end of the run
    int side = 0;                              // on which it touched first
    int count = 0;                             // of anchors
    Anchor anchors[2] = {};
  };
  /** A number or an equal-style variable. */
  struct Input {
    std::string variable;
    int index = -1;
    double value = 0.0;
  };
  /** A particle that may touch before all have moved "skin" in sum, at an image of it. */
  struct Candidate {
    int i;
    Point shift;    // to the image
  };
  /** A particle that may feel the wall in this step. */
  struct Touching {
    int i, places, side;
    Point x;        // at its image
    TMSPH::WallTouch place[2];
    double predicted[2], penetration[2];
    double stiffness;
    Point a;        // acceleration by all other forces, against the wall by its load
  };

  class PairTMSPH *pair;
  std::unique_ptr<TMSPH::WallShape> shape;
  TMSPH::RigidMotion motion;
  TMSPH::ContactLaw law;
  double friction, stiffness;    // stiffness: factor to the default
  bool both_sides;
  Input velocity[3], spin;       // prescribed
  bool turns;
  Input load[3];                 // of directions that are free
  bool is_free[3];
  double mass;                   // 0: no direction is free
  bool varies;                   // some input is a variable

  std::unordered_map<tagint, Memory> memories;    // by id
  std::vector<Candidate> candidates;              // images of a particle one after the other
  bool repeats[3];                                // the wall is there once in each period
  Point middle;                                   // of the wall
  bool warned;                                    // of a wall longer than that
  double skin, travel, farthest;                  // farthest: from the pivot, when they were listed
  int version;                                    // of the bonds when they were listed
  double way, clearance, radius;                  // see measure_clearance()
  bool started;                                   // this or an earlier run has been set up
  std::vector<Touching> touching;
  std::vector<Fix *> prescribing;                 // that act after it
  std::vector<std::array<double, 10>> picture;    // of the last image: a type, then corners
  std::vector<double *> picture_rows;
  std::vector<int> picture_kinds;

  enum { FORCE = 0, TORQUE = 3, WORK = 6, TOUCHES, DEEPEST, NTOTALS };
  enum { DISPLACEMENT = NTOTALS, ANGLE = NTOTALS + 3, NOUTPUT };
  double totals[NTOTALS];        // of this processor
  double energy;

  int parse_shape(int, char **);
  int parse_polyline(int, char **);
  std::vector<Point> read_polyline(const std::string &file) const;
  void check_points(const std::vector<Point> &) const;
  void parse(int, int, char **);
  Input number_or_variable(const char *) const;
  double evaluate(Input &);
  void evaluate_inputs();
  void find_periods();
  void list_candidates();
  Point position_of(int i) const;
  void list_images(int i, double within, double &nearest);
  void measure_clearance(double nearest);
  void follow();
  void to_image_near(const Point &x, Point &p) const;
  bool touch(const Candidate &, Touching &) const;
  void predict(Touching &, double dt) const;
  double gap_of(int i) const;
  double half_row(int i, const Point &normal) const;
  double stiffness_of(int i, double penetration, double dt) const;
  void find_touching(double dt);
  void act(double dt);
  void hold(Touching &, double dt, double dragged);
  void drive(double dt);
  void check_place() const;
  double depth_in_body(bigint &bonds_cut) const;
  bool cuts(Point from, Point to) const;
  bool all_behind() const;
  std::vector<Point> corners() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
