package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.DistanceSensor;
import io.dronefleet.mavlink.common.MavDistanceSensor;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * A radar, laser or ultrasonic range finder or altimeter that sends MAVLink DISTANCE_SENSOR (132),
 * or an autopilot that forwards it (mavlink.io/en/messages/common.html). Receive-only.
 *
 * <p>Distances below the sensor's minimum count as the minimum.
 */
public final class MavlinkRange extends MavlinkListener<RangeFinder.Distance>
    implements RangeFinder {
  private static final double CENTI = 1.0e-2;
  private static final int INVALID = 1; // signal_quality; 0 is unknown, 100 perfect
  private static final int ANY_ID = -1;

  /** The values of MAV_DISTANCE_SENSOR, in their order. */
  enum Kind {
    LASER,
    ULTRASOUND,
    INFRARED,
    RADAR,
    UNKNOWN,
    ANY
  }

  private final Kind kind;
  private final int id;

  /**
   * Uses the link; closing the device closes it.
   *
   * @param kind sensor type to accept
   * @param id sensor ID to accept; −1 for any
   */
  MavlinkRange(ByteLink link, Kind kind, int id) {
    super(link);
    this.kind = kind;
    this.id = id;
  }

  @Override
  void take(Object payload, long nowMicros) {
    if (!(payload instanceof DistanceSensor sensor) || !isMine(sensor)) {
      return;
    }
    int least = sensor.minDistance();
    int most = sensor.maxDistance();
    if (least > most) {
      refuse("DISTANCE_SENSOR from " + least + " to " + most + " cm");
      return;
    }
    if (sensor.signalQuality() == INVALID) {
      return; // the sensor reports an invalid measurement
    }
    int now = sensor.currentDistance();
    latest =
        Optional.of(
            new Distance(
                nowMicros,
                now > most
                    ? OptionalDouble.empty()
                    : OptionalDouble.of(Math.max(least, now) * CENTI)));
  }

  private boolean isMine(DistanceSensor sensor) {
    MavDistanceSensor type = sensor.type().entry();
    boolean isOfKind = kind == Kind.ANY || type != null && type.ordinal() == kind.ordinal();
    return isOfKind && (id == ANY_ID || id == sensor.id());
  }

  /** Provider of MODEL = MAVLINK. */
  public static final class Provider extends LinkProvider<RangeFinder> {
    private record Choice(
        @Variable(ifAbsentText = "ANY") @Description("MAVLINK: type of the sensor.")
            Kind distanceSensorKind,
        @Variable(min = -1, max = 255, ifAbsent = -1)
            @Description("MAVLINK: ID of the sensor; -1: any.")
            int distanceSensorId) {}

    public Provider() {
      super(
          RangeFinder.class,
          Choice.class,
          (name, link, choice) ->
              new MavlinkRange(link, choice.distanceSensorKind(), choice.distanceSensorId()),
          "MAVLINK");
    }
  }
}
