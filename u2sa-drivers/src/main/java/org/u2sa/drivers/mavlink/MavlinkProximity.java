package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.ObstacleDistance;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.messages.RangeScan;

/**
 * A radar, lidar or camera that sends MAVLink OBSTACLE_DISTANCE (330), or an autopilot that
 * forwards it (mavlink.io/en/messages/common.html). Receive-only.
 *
 * <p>Distances about north (frame GLOBAL, the message's default) are rejected, because a scan is in
 * sensor axes. Directions outside the field of view have no beam. Distances below the minimum count
 * as the minimum; 0 means contact.
 */
public final class MavlinkProximity extends MavlinkListener<LaserScanner.Scan>
    implements LaserScanner {
  private static final double CENTI = 1.0e-2;
  private static final int NOT_MEASURED = 65_535;
  private static final int BODY_FRD = 12; // MAV_FRAME_BODY_FRD

  public MavlinkProximity(ByteLink link) {
    super(link);
  }

  @Override
  void take(Object payload, long nowMicros) {
    if (!(payload instanceof ObstacleDistance obstacles)) {
      return;
    }
    double stepDeg =
        obstacles.incrementF() != 0.0f ? obstacles.incrementF() : obstacles.increment();
    boolean isPlaced = obstacles.frame().value() == BODY_FRD;
    boolean isMeasured =
        Double.isFinite(stepDeg)
            && stepDeg != 0.0
            && Float.isFinite(obstacles.angleOffset())
            && obstacles.minDistance() <= obstacles.maxDistance();
    if (!isPlaced || !isMeasured) {
      refuse(
          isPlaced
              ? String.format(
                  Locale.ROOT,
                  "OBSTACLE_DISTANCE from %d to %d cm, in steps of %.3f deg from %.3f deg",
                  obstacles.minDistance(),
                  obstacles.maxDistance(),
                  stepDeg,
                  obstacles.angleOffset())
              : "OBSTACLE_DISTANCE in frame "
                  + obstacles.frame().value()
                  + "; expected 12, MAV_FRAME_BODY_FRD");
      return;
    }
    List<RangeScan.Beam> beams = beams(obstacles, stepDeg);
    if (!beams.isEmpty()) {
      RangeScan scan =
          new RangeScan()
              .minRange(obstacles.minDistance() * CENTI)
              .maxRange(obstacles.maxDistance() * CENTI)
              .beams(beams);
      scan.timestamp(nowMicros);
      latest = Optional.of(new Scan(nowMicros, scan));
    }
  }

  /** MAVLink angles are clockwise from ahead; scan angles are left positive. */
  private static List<RangeScan.Beam> beams(ObstacleDistance obstacles, double stepDeg) {
    List<RangeScan.Beam> beams = new ArrayList<>();
    for (int i = 0; i < obstacles.distances().size(); i++) {
      int distance = obstacles.distances().get(i);
      if (distance != NOT_MEASURED) {
        double angleRad = -Math.toRadians(obstacles.angleOffset() + i * stepDeg);
        beams.add(
            new RangeScan.Beam(
                Math.IEEEremainder(angleRad, 2.0 * Math.PI),
                distance > obstacles.maxDistance()
                    ? OptionalDouble.empty()
                    : OptionalDouble.of(Math.max(obstacles.minDistance(), distance) * CENTI)));
      }
    }
    return beams;
  }

  /** Provider of LIDAR = mavlink. */
  public static final class Provider extends LinkProvider<LaserScanner> {
    public Provider() {
      super(LaserScanner.class, MavlinkProximity::new, "mavlink");
    }
  }
}
