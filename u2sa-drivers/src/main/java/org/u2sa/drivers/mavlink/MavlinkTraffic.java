package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.AdsbFlags;
import io.dronefleet.mavlink.common.AdsbVehicle;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.TrafficPicture;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;

/**
 * A transponder or receiver that sends MAVLink ADSB_VEHICLE (246), such as uAvionix ping, or an
 * autopilot that forwards it (mavlink.io/en/messages/common.html). Receive-only.
 */
public final class MavlinkTraffic extends MavlinkListener<TrafficReceiver.Traffic>
    implements TrafficReceiver {
  private static final double DEGREES = 1.0e-7;
  private static final double MILLI = 1.0e-3;
  private static final double CENTI = 1.0e-2;
  private static final int GEOMETRIC = 1;
  private static final double MAX_LATITUDE_DEG = 90.0;
  private static final double MAX_LONGITUDE_DEG = 180.0;

  private final TrafficPicture picture = new TrafficPicture();

  public MavlinkTraffic(ByteLink link) {
    super(link);
  }

  @Override
  void take(Object payload, long nowMicros) {
    if (payload instanceof AdsbVehicle vehicle) {
      vehicle(vehicle, nowMicros);
    } else {
      picture.alive(nowMicros);
    }
    latest = picture.latest();
  }

  private void vehicle(AdsbVehicle vehicle, long nowMicros) {
    double latitudeDeg = vehicle.lat() * DEGREES;
    double longitudeDeg = vehicle.lon() * DEGREES;
    boolean isOnEarth =
        Math.abs(latitudeDeg) <= MAX_LATITUDE_DEG && Math.abs(longitudeDeg) <= MAX_LONGITUDE_DEG;
    if (!isOnEarth) {
      refuse(
          String.format(
              Locale.ROOT,
              "ADSB_VEHICLE at latitude %.7f, longitude %.7f deg",
              latitudeDeg,
              longitudeDeg));
    }
    if (!isOnEarth || !has(vehicle, AdsbFlags.ADSB_FLAGS_VALID_COORDS)) {
      picture.alive(nowMicros);
      return;
    }
    TrafficTarget target =
        new TrafficTarget(
            String.format(Locale.ROOT, "%06X", vehicle.icaoAddress() & 0xFFFFFF),
            has(vehicle, AdsbFlags.ADSB_FLAGS_VALID_CALLSIGN) ? vehicle.callsign().trim() : "",
            "aircraft",
            Math.max(0, nowMicros - Clock.micros(vehicle.tslc())),
            latitudeDeg,
            longitudeDeg,
            has(vehicle, AdsbFlags.ADSB_FLAGS_VALID_ALTITUDE)
                ? OptionalDouble.of(vehicle.altitude() * MILLI)
                : OptionalDouble.empty(),
            // documented as QNH, but transponders report pressure altitude at 1013.25 hPa
            vehicle.altitudeType().value() != GEOMETRIC,
            velocity(vehicle),
            OptionalDouble.empty());
    picture.heard(target, nowMicros);
  }

  private static Optional<Point> velocity(AdsbVehicle vehicle) {
    boolean isKnown =
        has(vehicle, AdsbFlags.ADSB_FLAGS_VALID_VELOCITY)
            && has(vehicle, AdsbFlags.ADSB_FLAGS_VALID_HEADING);
    if (!isKnown) {
      return Optional.empty();
    }
    double mps = vehicle.horVelocity() * CENTI;
    double course = Math.toRadians(vehicle.heading() * CENTI); // course over ground
    double upMps =
        has(vehicle, AdsbFlags.ADSB_FLAGS_VERTICAL_VELOCITY_VALID)
            ? vehicle.verVelocity() * CENTI
            : 0.0;
    return Optional.of(Point.of(mps * Math.sin(course), mps * Math.cos(course), upMps));
  }

  private static boolean has(AdsbVehicle vehicle, AdsbFlags flag) {
    return vehicle.flags().flagsEnabled(flag);
  }

  /** Provider of RECEIVER = MAVLINK. */
  public static final class Provider extends LinkProvider<TrafficReceiver> {
    public Provider() {
      super(TrafficReceiver.class, MavlinkTraffic::new, "MAVLINK");
    }
  }
}
