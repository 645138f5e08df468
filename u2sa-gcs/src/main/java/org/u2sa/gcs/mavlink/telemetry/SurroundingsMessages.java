package org.u2sa.gcs.mavlink.telemetry;

import io.dronefleet.mavlink.common.AdsbAltitudeType;
import io.dronefleet.mavlink.common.AdsbFlags;
import io.dronefleet.mavlink.common.AdsbVehicle;
import io.dronefleet.mavlink.common.MavDistanceSensor;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.ObstacleDistance;
import io.dronefleet.mavlink.common.ServoOutputRaw;
import io.dronefleet.mavlink.common.WindCov;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.gcs.mavlink.vehicle.VehicleSurroundings;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.MovingSphere;

/** Messages about obstacles, traffic, wind and the outputs to the actuators. */
final class SurroundingsMessages {
  private static final int SECTORS = 72;
  private static final double SECTOR_DEG = 360.0 / SECTORS;
  private static final int UNKNOWN_CM = 0xFFFF;
  private static final double CENTI = 100.0;
  private static final double MILLI = 1000.0;
  private static final double E7 = 1.0e7;
  private static final int CENTRE = 1500; // [µs]
  private static final double MICROS_PER_PERCENT = 5.0;
  private static final int MAX_OUTPUTS = 16;
  private static final String ICAO = "traffic [0-9a-fA-F]{6}";

  private final VehicleSurroundings surroundings;
  private final Placement placement;
  private final Uptime uptime;
  private int nextAircraft;

  SurroundingsMessages(VehicleSurroundings surroundings, Placement placement, Uptime uptime) {
    this.surroundings = surroundings;
    this.placement = placement;
    this.uptime = uptime;
  }

  /** The nearest echo in each sector of 5°, clockwise from ahead. */
  Optional<Object> obstacles() {
    return surroundings
        .scan()
        .map(
            scan -> {
              Integer[] nearest = new Integer[SECTORS];
              int limit = centimetres(scan.maxRange());
              Arrays.fill(nearest, UNKNOWN_CM);
              scan.beams()
                  .forEach(beam -> nearer(nearest, -beam.angle() - scan.psi(), limit + 1)); // seen
              for (Point echo : scan.points()) {
                double right = Math.atan2(-echo.y(), echo.x());
                nearer(nearest, right, centimetres(Math.hypot(echo.x(), echo.y())));
              }
              return ObstacleDistance.builder()
                  .timeUsec(BigInteger.valueOf(uptime.micros()))
                  .sensorType(MavDistanceSensor.MAV_DISTANCE_SENSOR_LASER)
                  .distances(List.of(nearest))
                  .increment((int) SECTOR_DEG)
                  .minDistance(centimetres(scan.minRange()))
                  .maxDistance(limit)
                  .incrementF((float) SECTOR_DEG)
                  .frame(MavFrame.MAV_FRAME_BODY_FRD)
                  .build();
            });
  }

  private static void nearer(Integer[] nearest, double rightRad, int distanceCm) {
    int sector = (int) Math.round(Math.toDegrees(rightRad) / SECTOR_DEG);
    int index = Math.floorMod(sector, SECTORS);
    nearest[index] = Math.min(nearest[index], distanceCm);
  }

  private static int centimetres(double metres) {
    return (int) Math.max(0, Math.min(UNKNOWN_CM - 2, Math.round(metres * CENTI)));
  }

  /** The next of the other aircraft that have a transponder address, in turn. */
  Optional<Object> traffic() {
    List<MovingSphere> known =
        surroundings.aircraft().stream()
            .filter(each -> each.uid().matches(ICAO))
            .collect(Collectors.toList());
    if (known.isEmpty()) {
      return Optional.empty();
    }
    MovingSphere aircraft = known.get(nextAircraft++ % known.size());
    Optional<Point> velocity = aircraft.motion().velocity(); // east, north, up
    int flags =
        bit(AdsbFlags.ADSB_FLAGS_VALID_COORDS)
            | bit(AdsbFlags.ADSB_FLAGS_VALID_ALTITUDE)
            | (velocity.isPresent()
                ? bit(AdsbFlags.ADSB_FLAGS_VALID_HEADING) | bit(AdsbFlags.ADSB_FLAGS_VALID_VELOCITY)
                : 0);
    Point v = velocity.orElse(Point.of(0.0, 0.0, 0.0));
    double headingDeg = (Math.toDegrees(Math.atan2(v.x(), v.y())) + 360.0) % 360.0;
    return Optional.of(
        AdsbVehicle.builder()
            .icaoAddress(Long.parseLong(aircraft.uid().substring("traffic ".length()), 16))
            .lat(MotionMessages.scaled(aircraft.y(), E7))
            .lon(MotionMessages.scaled(aircraft.x(), E7))
            .altitudeType(AdsbAltitudeType.ADSB_ALTITUDE_TYPE_GEOMETRIC)
            .altitude(MotionMessages.scaled(aircraft.z(), MILLI))
            .heading((int) Math.round(headingDeg * CENTI))
            .horVelocity(centimetres(Math.hypot(v.x(), v.y())))
            .verVelocity((int) Math.round(v.z() * CENTI))
            .callsign("")
            .flags(EnumValue.create(AdsbFlags.class, flags))
            .build());
  }

  private static int bit(AdsbFlags flag) {
    return EnumValue.of(flag).value();
  }

  /** Wind, from the motion over ground and through the air. */
  Optional<Object> wind() {
    Optional<StateInformation> state =
        placement.attitude().filter(now -> now.fluidxDot().isPresent());
    Optional<Point> ground = placement.velocity();
    if (state.isEmpty() || ground.isEmpty() || state.get().fluidyDot().isEmpty()) {
      return Optional.empty();
    }
    StateInformation now = state.get();
    Point air =
        new Attitude(now.phi().orElse(0.0), now.theta().orElse(0.0), now.psi().getAsDouble())
            .nedOf(
                Point.of(
                    now.fluidxDot().getAsDouble(),
                    now.fluidyDot().getAsDouble(),
                    now.fluidzDot().orElse(0.0)));
    Point wind = ground.get().minus(air);
    return Optional.of(
        WindCov.builder()
            .timeUsec(BigInteger.valueOf(uptime.micros()))
            .windX((float) wind.x())
            .windY((float) wind.y())
            .windZ(now.fluidzDot().isPresent() ? (float) wind.z() : Float.NaN)
            .varHoriz(Float.NaN)
            .varVert(Float.NaN)
            .windAlt((float) now.z().orElse(Double.NaN))
            .horizAccuracy(Float.NaN)
            .vertAccuracy(Float.NaN)
            .build());
  }

  /** Commands as pulses of 1000…2000 µs, in the order of the actuators' names. */
  Optional<Object> outputs() {
    List<Integer> pulses = new ArrayList<>();
    for (double percent : surroundings.outputs()) {
      pulses.add((int) Math.round(CENTRE + MICROS_PER_PERCENT * percent));
    }
    if (pulses.isEmpty()) {
      return Optional.empty();
    }
    while (pulses.size() < MAX_OUTPUTS) {
      pulses.add(0); // none
    }
    return Optional.of(
        ServoOutputRaw.builder()
            .timeUsec(uptime.micros() & 0xFFFF_FFFFL)
            .servo1Raw(pulses.get(0))
            .servo2Raw(pulses.get(1))
            .servo3Raw(pulses.get(2))
            .servo4Raw(pulses.get(3))
            .servo5Raw(pulses.get(4))
            .servo6Raw(pulses.get(5))
            .servo7Raw(pulses.get(6))
            .servo8Raw(pulses.get(7))
            .servo9Raw(pulses.get(8))
            .servo10Raw(pulses.get(9))
            .servo11Raw(pulses.get(10))
            .servo12Raw(pulses.get(11))
            .servo13Raw(pulses.get(12))
            .servo14Raw(pulses.get(13))
            .servo15Raw(pulses.get(14))
            .servo16Raw(pulses.get(15))
            .build());
  }
}
