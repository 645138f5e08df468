package org.u2sa.control.fixedwing;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.handover.HandOver;

/**
 * Converts state messages in GLOBAL to {@link FlightState}s: Euler rates to body rates, geodetic
 * positions to metres from the first one. Horizontal position and velocity keep their last values
 * when lost, because the wings can be held level without them.
 */
final class FlightStateReader {
  private static final List<StateField> NEEDED =
      List.of(
          StateField.X,
          StateField.Y,
          StateField.Z,
          StateField.X_DOT,
          StateField.Y_DOT,
          StateField.Z_DOT,
          StateField.PHI,
          StateField.THETA,
          StateField.PSI,
          StateField.PHI_DOT,
          StateField.THETA_DOT,
          StateField.PSI_DOT,
          StateField.FLUID_X_DOT);
  private static final Set<StateField> LOSABLE =
      EnumSet.of(StateField.X, StateField.Y, StateField.X_DOT, StateField.Y_DOT);
  private static final double HIGH_M = 1_000.0; // height of an aircraft with unknown height
  private static final double SLOWEST_MPS = 1.0; // below this, the airflow's direction is unknown

  private static final double ELECTRIC_RPM = 10_000.0; // reported by motors without a starter

  private final Supplier<GroundReference.Variables> settings;
  private final GroundReference ground = new GroundReference();
  private Geodetic origin; // origin of north and east
  private final Map<StateField, Double> last = new EnumMap<>(StateField.class); // may be lost

  FlightStateReader() {
    this(() -> new GroundReference.Variables(GroundReference.Source.STATE, 0.0));
  }

  FlightStateReader(Supplier<GroundReference.Variables> settings) {
    this.settings = settings;
  }

  /** Whether the altitude of the ground has been learnt, because the first flight has begun. */
  boolean hasFlown() {
    return ground.hasFlown();
  }

  /** Whether heights refer to a ground whose altitude was not learnt before the flight. */
  boolean lacksGround() {
    return settings.get().ground() == GroundReference.Source.START && !ground.isKnown();
  }

  /** Why a landing cannot be flown with such a state; empty if it can. */
  Optional<String> cannotLand(StateInformation state) {
    if (state instanceof AircraftState known && known.heightAboveGround().isPresent()) {
      return Optional.empty();
    }
    if (lacksGround()) {
      return Optional.of("the altitude of the ground is unknown: started in flight");
    }
    return settings.get().ground() == GroundReference.Source.START
        ? Optional.empty()
        : Optional.of("the state has no height above ground, and GROUND is not START");
  }

  /** Saves the origin of north and east. */
  void handOver(HandOver state) {
    if (ground.isKnown()) {
      ground.handOver(state);
    }
    if (origin != null) {
      state
          .number("ORIGIN LONGITUDE", origin.longitudeDeg())
          .number("ORIGIN LATITUDE", origin.latitudeDeg())
          .number("ORIGIN ALTITUDE", origin.altitudeM());
    }
    last.forEach((field, value) -> state.number("LAST " + field.fieldName(), value));
  }

  /** Adopts the predecessor's origin. */
  void takeOver(HandOver state) {
    ground.takeOver(state);
    if (state.number("ORIGIN LONGITUDE").isPresent()) {
      origin =
          new Geodetic(
              state.number("ORIGIN LONGITUDE").getAsDouble(),
              state.number("ORIGIN LATITUDE").orElseThrow(),
              state.number("ORIGIN ALTITUDE").orElseThrow());
    }
    for (StateField field : LOSABLE) {
      state.number("LAST " + field.fieldName()).ifPresent(value -> last.put(field, value));
    }
  }

  /** Fields missing for control; empty if none. */
  List<String> missing(StateInformation state) {
    List<String> missing = new ArrayList<>();
    if (!state.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      missing.add("a position in " + ReferenceFrame.GLOBAL);
    }
    for (StateField field : NEEDED) {
      if (state.number(field).isEmpty() && !last.containsKey(field)) {
        missing.add(field.fieldName());
      }
    }
    return missing;
  }

  /**
   * Converts a state for the laws; empty if a required value is {@linkplain #missing missing}. For
   * a message that is not an {@link AircraftState}, height above ground is measured from the start
   * position if so configured; otherwise it counts as airborne.
   */
  Optional<FlightState> read(StateInformation state) {
    if (!missing(state).isEmpty()) {
      return Optional.empty();
    }
    for (StateField field : LOSABLE) {
      state.number(field).ifPresent(value -> last.put(field, value));
    }
    Geodetic place =
        new Geodetic(last.get(StateField.X), last.get(StateField.Y), value(state, StateField.Z));
    if (origin == null) {
      origin = place;
    }
    Point ned = origin.nedOf(place);
    double roll = Limit.angle(value(state, StateField.PHI));
    double pitch = Limit.angle(value(state, StateField.THETA));
    double heading = value(state, StateField.PSI);
    Point rates =
        new Attitude(roll, pitch, heading)
            .bodyRates(
                Point.of(
                    value(state, StateField.PHI_DOT),
                    value(state, StateField.THETA_DOT),
                    value(state, StateField.PSI_DOT)));
    double forward = value(state, StateField.FLUID_X_DOT);
    double right = -state.fluidyDot().orElse(0.0); // BODY: y is to the left
    double climb = value(state, StateField.Z_DOT);
    double down = state.fluidzDot().orElse(forward * StrictMath.tan(pitch) - climb);
    double speed = StrictMath.sqrt(forward * forward + right * right + down * down);
    boolean moving = speed > SLOWEST_MPS;
    AircraftState aircraft = state instanceof AircraftState known ? known : null;
    OptionalDouble calibrated =
        aircraft == null ? OptionalDouble.empty() : aircraft.calibratedAirspeed();
    double timeS = Clock.seconds(state.timestamp().orElse(0L));
    double overGround = StrictMath.hypot(last.get(StateField.X_DOT), last.get(StateField.Y_DOT));
    ground.see(timeS, place.altitudeM(), overGround, settings.get().startHeight());
    boolean fromStart = settings.get().ground() == GroundReference.Source.START && ground.isKnown();
    double heightM = fromStart ? ground.heightM(place.altitudeM()) : HIGH_M;
    return Optional.of(
        new FlightState(
            timeS,
            ned.x(),
            ned.y(),
            place.altitudeM(),
            aircraft == null ? heightM : aircraft.heightAboveGround().orElse(heightM),
            roll,
            pitch,
            heading,
            rates.x(),
            rates.y(),
            rates.z(),
            last.get(StateField.Y_DOT),
            last.get(StateField.X_DOT),
            climb,
            speed,
            calibrated.orElse(speed * rootDensityRatio(place.altitudeM())),
            moving ? StrictMath.atan2(down, forward) : 0.0,
            moving ? StrictMath.asin(Limit.symmetric(right / speed, 1.0)) : 0.0,
            aircraft == null
                ? fromStart && ground.isOnGround(place.altitudeM())
                : aircraft.weightOnWheels(),
            aircraft == null ? (fromStart ? ELECTRIC_RPM : 0.0) : aircraft.engineRpm().orElse(0.0),
            aircraft != null && aircraft.engineStarting(),
            aircraft != null,
            state.xDot().isPresent() && state.yDot().isPresent()));
  }

  private static double value(StateInformation state, StateField field) {
    return state.number(field).orElseThrow();
  }

  /** √(ρ/ρ0) of the standard atmosphere up to 11 km: equivalent over true airspeed. */
  private static double rootDensityRatio(double altitudeM) {
    double temperature = Limit.within(0.75, 1.0 - 2.25577e-5 * altitudeM, 1.1);
    return StrictMath.sqrt(StrictMath.pow(temperature, 4.2559));
  }
}
