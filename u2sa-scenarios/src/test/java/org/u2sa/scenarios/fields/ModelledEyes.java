package org.u2sa.scenarios.fields;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;

/**
 * The World Modeler's grid and tracks of what a laser and perhaps a detector of objects measure ten
 * times a second, both with errors: the laser sees traffic too, the detector tells no velocities
 * and gives no names of their own.
 */
final class ModelledEyes implements RoverEyes {
  private static final int LOOK_EVERY = 2;
  private static final int BEAMS = 480;
  private static final double STEP_RAD = 2.0 * Math.PI / BEAMS;
  private static final double LASER_SIGMA_M = 0.03;
  private static final double LASER_UP_M = 0.3;
  private static final double DETECTOR_SIGMA_M = 0.1;

  private final RandomField field;
  private final World world;
  private final ServiceKit kit;
  private final boolean detects;
  private final Random noise;
  private int step;

  ModelledEyes(RandomField field, World world, ServiceKit kit, boolean detects) {
    this.field = field;
    this.world = world;
    this.kit = kit;
    this.detects = detects;
    noise = new Random(field.seed);
    kit.withoutVariables(); // as in config/ugv/WorldModeler.xml
    kit.with("CELL SIZE", 0.1).with("GRID SIZE", 60.0).with("LOWEST", 0.05);
    if (detects) {
      kit.with("MOVERS IN SCANS", false);
      kit.with("SCANNERS SEE", "walker").with("FORGET STANDING", 10.0); // who stands may walk on
    }
    kit.start(WorldModeler::new);
  }

  @Override
  public void look(VehicleTruth truth) {
    if (step++ % LOOK_EVERY == 0) {
      kit.send(Channels.SCANS, scan(truth));
      if (detects) {
        field.traffic.forEach(other -> detect(truth, other));
      }
      kit.settle();
    }
  }

  private RangeScan scan(VehicleTruth truth) {
    List<OptionalDouble> ranges = new ArrayList<>(BEAMS);
    for (int beam = 0; beam < BEAMS; beam++) {
      double far =
          nearest(truth, truth.headingRad() - beam * STEP_RAD) // beams go round to the left
              + LASER_SIGMA_M * noise.nextGaussian();
      ranges.add(far > 0.05 && far <= RANGE_M ? OptionalDouble.of(far) : OptionalDouble.empty());
    }
    return new RangeScan()
        .sensorName("Laser")
        .referenceFrame(ReferenceFrame.BODY)
        .z(-LASER_UP_M) // BODY's z points down
        .minRange(0.05)
        .maxRange(RANGE_M)
        .beams(0.0, STEP_RAD, ranges);
  }

  /** To what stands or moves in a direction [m]. */
  private double nearest(VehicleTruth truth, double azimuth) {
    Point at = truth.position();
    double least = standing(at, azimuth);
    double now = kit.nowS();
    for (RandomField.Traffic other : field.traffic) {
      double de = other.eastM(now) - at.x();
      double dn = other.northM(now) - at.y();
      double along = de * Math.sin(azimuth) + dn * Math.cos(azimuth);
      double beside = de * Math.cos(azimuth) - dn * Math.sin(azimuth);
      double half = other.radiusM * other.radiusM - beside * beside;
      if (along > 0.0 && half > 0.0) {
        least = Math.min(least, Math.max(0.0, along - Math.sqrt(half)));
      }
    }
    return least;
  }

  private double standing(Point at, double azimuth) {
    return world.distanceM(Ray.of(Point.of(at.x(), at.y(), LASER_UP_M), azimuth, 0.0), RANGE_M);
  }

  /** Sees one that moves, unless something stands before it or it is too far away. */
  private void detect(VehicleTruth truth, RandomField.Traffic other) {
    Point at = truth.position();
    double de = other.eastM(kit.nowS()) - at.x();
    double dn = other.northM(kit.nowS()) - at.y();
    double away = Math.hypot(de, dn);
    if (away > RANGE_M || standing(at, Math.atan2(de, dn)) < away) {
      return;
    }
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    ObjectDescription seen =
        new Circle()
            .radius(other.radiusM)
            .uid("seen")
            .objectType("walker")
            .sensorName("Detector")
            .referenceFrame(ReferenceFrame.BODY)
            .x(de * sin + dn * cos + DETECTOR_SIGMA_M * noise.nextGaussian())
            .y(-de * cos + dn * sin + DETECTOR_SIGMA_M * noise.nextGaussian());
    seen.motion().sigma(Point.of(DETECTOR_SIGMA_M, DETECTOR_SIGMA_M, DETECTOR_SIGMA_M));
    kit.send(Channels.SENSED_OBJECTS, seen);
  }
}
