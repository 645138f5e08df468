package org.u2sa.sim.camera;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Pose of a camera in the world (east, north, up). Mutable and reused. */
final class CameraPose {
  private static final double STEEP_RAD = 1.5;

  private final Point ahead; // camera axes in the vehicle frame: forward, right, down
  private final Point down;
  private final Point mounted;
  float x;
  float y;
  float z;
  final float[] right = new float[3];
  final float[] below = new float[3];
  final float[] axis = new float[3];

  CameraPose(ColourLens lens) {
    double sin = StrictMath.sin(lens.downRad());
    double cos = StrictMath.cos(lens.downRad());
    ahead = Point.of(cos, 0.0, sin);
    down = Point.of(-sin, 0.0, cos);
    mounted = Point.of(lens.forwardM(), -lens.leftM(), -lens.upM());
  }

  /** Sets the pose, extrapolated with the vehicle's motion. */
  void at(VehicleTruth truth, double laterS) {
    Rotation ned = later(truth.attitude(), truth.rates(), laterS);
    Point place = ned.times(mounted);
    x = (float) (truth.position().x() + laterS * truth.velocity().x() + place.y());
    y = (float) (truth.position().y() + laterS * truth.velocity().y() + place.x());
    z = (float) (truth.position().z() + laterS * truth.velocity().z() - place.z());
    enu(ned.times(Point.of(0.0, 1.0, 0.0)), right);
    enu(ned.times(down), below);
    enu(ned.times(ahead), axis);
  }

  private static Rotation later(Attitude now, Point rates, double laterS) {
    if (Math.abs(now.theta()) > STEEP_RAD) { // Euler rates grow without bound
      Attitude turn = new Attitude(laterS * rates.x(), laterS * rates.y(), laterS * rates.z());
      return now.nedFromFrd().times(turn.nedFromFrd());
    }
    Point turning = now.eulerRates(rates);
    return new Attitude(
            now.phi() + laterS * turning.x(),
            now.theta() + laterS * turning.y(),
            now.psi() + laterS * turning.z())
        .nedFromFrd();
  }

  private static void enu(Point ned, float[] into) {
    into[0] = (float) ned.y();
    into[1] = (float) ned.x();
    into[2] = (float) -ned.z();
  }
}
