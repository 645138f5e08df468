package org.u2sa.estimation;

import java.util.Collection;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * A simple alternative between pass-through and full fusion: slow but drift-free measurements of a
 * value (position, heading) pull the estimate with a time constant; fast measurements of its rate
 * (velocity, turn rate) propagate it in between (complementary filter, Higgins 1975). In:
 * sensed-state. Out: state, at the time of the newest measurement, in GLOBAL; only position and
 * heading with their rates. A measurement older than the newest, such as a GPS fix with 0.1 s
 * latency, is extrapolated to the state's time by the measured rates.
 *
 * <p>Each standard deviation comes from the value's latest source. Sources are not checked for
 * faults.
 */
public final class ComplementaryStateEstimator extends StateEstimator {
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double EARTH_RADIUS_M = 6_371_000.0; // accurate enough for a correction
  private static final double DEG_PER_M = Math.toDegrees(1.0 / EARTH_RADIUS_M);

  private record Variables(
      @Variable(unit = "s", min = 0, ifAbsent = 1)
          @Description("Time constant of the correction by measured positions; 0: immediate.")
          double positionTime,
      @Variable(unit = "s", min = 0, ifAbsent = 0.5)
          @Description("Time constant of the correction by measured headings; 0: immediate.")
          double headingTime,
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 2)
          @Description(
              "Age at which a measured rate, position or heading expires, even if it arrives late.")
          double staleAfter) {}

  /** A value that is pulled by its measurements and propagated by its rate. */
  private static final class Channel {
    private double value;
    private double sigma;
    private double rate;
    private boolean hasValue;
    private boolean hasRate;
    private final Map<String, Long> pulls = new TreeMap<>(); // last measurement by source [µs]
    private long pulledMicros;
    private long rateMicros;

    void moveOn(double seconds, double perUnit) {
      value += moved(seconds, perUnit);
    }

    void rate(double newRate, long micros) {
      if (hasRate && micros < rateMicros) {
        return; // a newer rate is known
      }
      rate = newRate;
      hasRate = true;
      rateMicros = micros;
    }

    /** Change of the value over that time at the current rate. */
    double moved(double seconds, double perUnit) {
      return hasRate ? rate * seconds * perUnit : 0.0;
    }

    /**
     * Each source is weighted by the time since its own previous measurement, because any source
     * may be late. Without a rate, the value would lag behind its measurements: it follows at once.
     */
    void pull(String source, double apart, double newSigma, double timeS, long micros) {
      Long before = pulls.put(source, micros);
      double seconds =
          Math.max(0.0, Clock.seconds(micros - (before == null ? pulledMicros : before)));
      double share = hasValue && hasRate && timeS > 0.0 ? 1.0 - Math.exp(-seconds / timeS) : 1.0;
      value += share * apart;
      sigma = newSigma;
      pulledMicros = hasValue ? Math.max(pulledMicros, micros) : micros;
      hasValue = true;
    }

    void forget(long now, long staleMicros) {
      hasValue &= now - pulledMicros <= staleMicros;
      hasRate &= now - rateMicros <= staleMicros;
      pulls.values().removeIf(micros -> now - micros > staleMicros);
    }
  }

  private static final Set<StateField> ESTIMATED =
      EnumSet.of(
          StateField.X,
          StateField.Y,
          StateField.Z,
          StateField.PSI,
          StateField.X_DOT,
          StateField.Y_DOT,
          StateField.Z_DOT,
          StateField.PSI_DOT);

  private final Variables tuning;
  private final Completeness completeness;
  private final Channel longitude = new Channel();
  private final Channel latitude = new Channel();
  private final Channel altitude = new Channel();
  private final Channel heading = new Channel();
  private final Map<String, StateInformation> newest = new TreeMap<>();
  private long micros = Long.MIN_VALUE;

  /**
   * Launcher constructor.
   *
   * @throws org.u2sa.interfaces.BadInputException if NEEDED names a number that this estimator never
   *     provides, such as roll
   */
  public ComplementaryStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
    completeness = NeededNumbers.watch(this, ESTIMATED);
    tuning = settings(Variables.class).get(); // changes take effect at the next start
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    if (sensed instanceof LandmarkSighting) {
      return Optional.empty(); // needs a filter
    }
    if (isFromTheFuture(sensed)) { // would make all later measurements look too old
      return Optional.empty();
    }
    long measuredAt = sensed.timestamp().orElseThrow();
    if (micros != Long.MIN_VALUE && micros - measuredAt > Clock.micros(tuning.staleAfter())) {
      ignore(sensed, "is later than STALE AFTER");
      return Optional.empty();
    }
    moveOn(Math.max(micros, measuredAt));
    newest.put(sensed.sensorName(), sensed);
    take(sensed, measuredAt);
    StateInformation state = state(micros);
    completeness.look(state, newest.values());
    return Optional.of(state);
  }

  private void moveOn(long now) {
    double seconds = micros == Long.MIN_VALUE ? 0.0 : Clock.seconds(now - micros);
    micros = now;
    longitude.moveOn(seconds, DEG_PER_M / Math.cos(Math.toRadians(latitude.value)));
    latitude.moveOn(seconds, DEG_PER_M);
    altitude.moveOn(seconds, 1.0);
    heading.moveOn(seconds, 1.0);
    long stale = Clock.micros(tuning.staleAfter());
    for (Channel each : new Channel[] {longitude, latitude, altitude, heading}) {
      each.forget(now, stale);
    }
  }

  private void take(StateInformation sensed, long measuredAt) {
    ReferenceFrame frame = sensed.referenceFrame();
    if (frame.isBody()) {
      takeBody(sensed, measuredAt);
    } else if (frame.isEarth()) {
      takeGlobal(sensed.in(ReferenceFrame.GLOBAL), measuredAt);
    }
  }

  private void takeBody(StateInformation sensed, long measuredAt) {
    StateInformation frd = sensed.in(ReferenceFrame.BODY_FRD);
    frd.psiDot().ifPresent(rate -> heading.rate(rate, measuredAt));
    if (frd instanceof InertialMeasurement inertial) {
      inertial.yawRate().ifPresent(rate -> heading.rate(rate, measuredAt));
    }
    if (frd.xDot().isPresent() && heading.hasValue) {
      double forward = frd.xDot().getAsDouble();
      double right = frd.yDot().orElse(0.0);
      double sin = StrictMath.sin(heading.value);
      double cos = StrictMath.cos(heading.value);
      longitude.rate(forward * sin + right * cos, measuredAt);
      latitude.rate(forward * cos - right * sin, measuredAt);
    }
  }

  private void takeGlobal(StateInformation sensed, long measuredAt) {
    sensed.xDot().ifPresent(rate -> longitude.rate(rate, measuredAt));
    sensed.yDot().ifPresent(rate -> latitude.rate(rate, measuredAt));
    sensed.zDot().ifPresent(rate -> altitude.rate(rate, measuredAt));
    sensed.psiDot().ifPresent(rate -> heading.rate(rate, measuredAt));
    if (sensed.x().isPresent() && sensed.y().isPresent()) {
      pull(latitude, DEG_PER_M, sensed, StateField.Y, StateField.Y_SIGMA);
      double perM = DEG_PER_M / Math.cos(Math.toRadians(latitude.value));
      pull(longitude, perM, sensed, StateField.X, StateField.X_SIGMA);
    }
    pull(altitude, 1.0, sensed, StateField.Z, StateField.Z_SIGMA);
    pull(heading, 1.0, sensed, StateField.PSI, StateField.PSI_SIGMA);
  }

  /** Pulls a channel toward a measured value, extrapolated to the state's time by its rate. */
  private void pull(
      Channel channel,
      double perUnit,
      StateInformation sensed,
      StateField field,
      StateField sigma) {
    OptionalDouble measured = sensed.number(field);
    if (measured.isEmpty()) {
      return;
    }
    long measuredAt = sensed.timestamp().orElseThrow();
    double ageS = Clock.seconds(micros - measuredAt);
    double apart = measured.getAsDouble() + channel.moved(ageS, perUnit) - channel.value;
    double way =
        field == StateField.X
            ? Math.IEEEremainder(apart, 360.0)
            : field == StateField.PSI ? Math.IEEEremainder(apart, FULL_TURN) : apart;
    double timeS = field == StateField.PSI ? tuning.headingTime() : tuning.positionTime();
    double sigmaOf = sensed.number(sigma).orElse(0.0);
    channel.pull(sensed.sensorName(), way, sigmaOf, timeS, measuredAt);
  }

  private StateInformation state(long now) {
    StateInformation state = new StateInformation();
    state.timestamp(now);
    put(state, longitude, StateField.X, StateField.X_SIGMA, StateField.X_DOT);
    put(state, latitude, StateField.Y, StateField.Y_SIGMA, StateField.Y_DOT);
    put(state, altitude, StateField.Z, StateField.Z_SIGMA, StateField.Z_DOT);
    put(state, heading, StateField.PSI, StateField.PSI_SIGMA, StateField.PSI_DOT);
    state.x().ifPresent(x -> state.x(Math.IEEEremainder(x, 360.0))); // across the date line
    state.psi().ifPresent(psi -> state.psi(turned(psi)));
    return state;
  }

  private static double turned(double angle) {
    double rest = angle % FULL_TURN;
    return rest < 0.0 ? rest + FULL_TURN : rest;
  }

  private static void put(
      StateInformation state,
      Channel channel,
      StateField value,
      StateField sigma,
      StateField rate) {
    if (channel.hasValue) {
      state.number(value, channel.value);
      if (channel.sigma > 0.0) {
        state.number(sigma, channel.sigma);
      }
    }
    if (channel.hasRate) {
      state.number(rate, channel.rate);
    }
  }

  @Override
  protected void handOver(HandOver state) {
    state.messages("MEASUREMENTS", newest.values());
    if (micros != Long.MIN_VALUE) {
      state.message("STATE", state(micros));
    }
  }

  @Override
  protected void takeOver(HandOver state) {
    Collection<StateInformation> measured = state.messages("MEASUREMENTS", StateInformation.class);
    measured.stream()
        .sorted((a, b) -> Long.compare(a.timestamp().orElseThrow(), b.timestamp().orElseThrow()))
        .forEach(this::estimate);
    state.message("STATE", StateInformation.class).ifPresent(this::estimate);
  }
}
