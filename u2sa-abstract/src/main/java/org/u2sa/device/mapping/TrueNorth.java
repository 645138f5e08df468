package org.u2sa.device.mapping;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.OptionalDouble;
import org.u2sa.device.port.Heading;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.U2SAService;

/**
 * Converts magnetic to true headings for one service: by a fixed declination, or by the {@link
 * MagneticModel} at the vehicle's position.
 */
public final class TrueNorth {
  private static final double SAME_PLACE_DEG =
      0.02; // about 2 km: less than 0.01 deg of declination

  private enum North {
    MODEL,
    FIXED
  }

  private record Source(
      @Variable(ifAbsentText = "MODEL")
          @Description(
              "MODEL: World Magnetic Model at the vehicle's position (no heading until the position is known); FIXED: DECLINATION.")
          North north,
      @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
          @Description("Magnetic declination, east positive, if NORTH is FIXED.")
          double declination) {}

  private final boolean isModelled;
  private OptionalDouble declinationRad;
  private double latitudeDeg = Double.NaN;
  private double longitudeDeg = Double.NaN;

  /** Also subscribes the service to state for the vehicle's position. */
  public TrueNorth(U2SAService service, Clock clock) {
    this(service);
    service.subscribe(Channels.STATE, state -> at(state, clock.micros()));
  }

  public TrueNorth(Configurator variables) {
    Source source = variables.settings(Source.class).get();
    isModelled = source.north() == North.MODEL;
    declinationRad = isModelled ? OptionalDouble.empty() : OptionalDouble.of(source.declination());
  }

  /**
   * Updates the vehicle's position if the state has one in GLOBAL.
   *
   * @param nowMicros time since 1970; simulated time, which starts at 0, is clamped to the model's
   *     first year
   */
  public void at(StateInformation state, long nowMicros) {
    if (!isModelled
        || state.x().isEmpty()
        || state.y().isEmpty()
        || state.referenceFrame() != ReferenceFrame.GLOBAL) {
      return; // a local position is not a geographic one
    }
    double latitude = state.y().getAsDouble();
    double longitude = state.x().getAsDouble();
    boolean isSamePlace =
        Math.abs(latitude - latitudeDeg) < SAME_PLACE_DEG
            && Math.abs(longitude - longitudeDeg) < SAME_PLACE_DEG;
    if (!isSamePlace && Math.abs(latitude) <= 90.0) {
      latitudeDeg = latitude;
      longitudeDeg = longitude;
      declinationRad =
          OptionalDouble.of(
              MagneticModel.declinationRad(
                  latitude, longitude, state.z().orElse(0.0), year(nowMicros)));
    }
  }

  private static double year(long micros) {
    ZonedDateTime now =
        Instant.ofEpochSecond(Math.floorDiv(micros, Clock.MICROS_PER_SECOND))
            .atZone(ZoneOffset.UTC);
    return now.getYear() + (now.getDayOfYear() - 1) / (double) now.toLocalDate().lengthOfYear();
  }

  /**
   * True heading [rad, 0…2π]; empty while the declination is unknown.
   *
   * @param turnRad angle added to the heading: direction of the vehicle's front, clockwise from the
   *     compass's
   */
  public OptionalDouble of(Heading heading, double turnRad) {
    if (heading.isTrue()) {
      return OptionalDouble.of(Heading.turned(heading.headingRad() + turnRad));
    }
    return declinationRad.isPresent()
        ? OptionalDouble.of(
            Heading.turned(heading.headingRad() + declinationRad.getAsDouble() + turnRad))
        : OptionalDouble.empty();
  }
}
