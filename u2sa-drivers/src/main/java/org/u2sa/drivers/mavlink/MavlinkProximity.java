package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.ObstacleDistance;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.LaserScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ServiceContext;

/**
 * A radar, laser or camera that sends the distances around it by MAVLink's OBSTACLE_DISTANCE (330),
 * or an autopilot that passes them on (mavlink.io/en/messages/common.html). It only listens.
 *
 * <p>Distances about north (frame GLOBAL, the message's default) are refused: a scan is about the
 * sensor's own axes. Directions in which the sensor does not look have no beam. Nearer than the
 * least distance counts as that far: 0 is something that touches the sensor.
 */
public final class MavlinkProximity extends MavlinkListener<LaserScanner.Scan>
    implements LaserScanner {
  private static final double CENTI = 1.0e-2;
  private static final int NOT_MEASURED = 65_535;
  private static final int BODY_FRD = 12; // MAV_FRAME_BODY_FRD

  private Optional<Scan> latest = Optional.empty();

  /** Over that link, which is closed with this. */
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

  /** MAVLink counts angles clockwise from ahead, a scan to the left. */
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

  @Override
  protected Optional<Scan> latest() {
    return latest;
  }

  /** LIDAR mavlink in a configuration. */
  public static final class Provider extends DeviceProvider<LaserScanner> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(LaserScanner.class, "mavlink");
    }

    @Override
    protected LaserScanner open(String name, ServiceContext context) {
      return new MavlinkProximity(ByteLinks.of(context));
    }
  }
}
