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
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * A simple alternative between pass-through and full fusion: slow but drift-free measurements of a
 * value (position, heading) pull the estimate with a time constant; fast measurements of its rate
 * (velocity, turn rate) propagate it in between (complementary filter, Higgins 1975). In:
 * sensed-state. Out: state, at the time of the newest measurement, in GLOBAL; only position and
 * heading with their rates. Measured roll and pitch turn speeds along the vehicle's axes to the
 * earth's. A measurement older than the newest, such as a GPS fix with 0.1 s latency, is
 * extrapolated to the state's time by the measured rates.
 *
 * <p>Each standard deviation comes from the value's latest source; that of a position increases by
 * the error of the measured velocity since. Sources are not checked for faults.
 */
public final class ComplementaryStateEstimator extends StateEstimator {
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double EARTH_RADIUS_M = 6_371_000.0; // accurate enough for a correction
  private static final double DEG_PER_M = Math.toDegrees(1.0 / EARTH_RADIUS_M);
  private static final double USUAL_SIGMA_MPS = 0.1; // of a velocity without one
  private static final double LOST_M = 50.0; // standard deviation of a position no longer known

  private record Variables(
      @Variable(unit = "s", min = 0, ifAbsent = 1)
          @Description("Time constant of the correction by measured positions; 0: immediate.")
          double positionTime,
      @Variable(unit = "s", min = 0, ifAbsent = 0.5)
          @Description("Time constant of the correction by measured headings; 0: immediate.")
          double headingTime,
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 2)
          @Description(
              "Age at which a measured rate, position or heading expires, even if it arrives late. A position remains as long as its rate is measured, and becomes less certain.")
          double staleAfter) {}

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
  private final PropagatedValue longitude = new PropagatedValue();
  private final PropagatedValue latitude = new PropagatedValue();
  private final PropagatedValue altitude = new PropagatedValue();
  private final PropagatedValue heading = new PropagatedValue();
  private final Map<String, StateInformation> newest = new TreeMap<>();
  private long micros = Long.MIN_VALUE;
  private double phi; // of the newest measurement of roll and pitch
  private double theta;
  private long tiltMicros = Long.MIN_VALUE / 2;

  /**
   * Launcher constructor.
   *
   * @throws org.u2sa.interfaces.BadInputException if NEEDED names a number that this estimator
   *     never provides, such as roll
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
    longitude.moveOn(seconds, DEG_PER_M / Math.cos(Math.toRadians(latitude.value())));
    latitude.moveOn(seconds, DEG_PER_M);
    altitude.moveOn(seconds, 1.0);
    heading.moveOn(seconds, 1.0);
    long stale = Clock.micros(tuning.staleAfter());
    longitude.forget(now, stale, LOST_M);
    latitude.forget(now, stale, LOST_M);
    altitude.forget(now, stale, 0.0);
    heading.forget(now, stale, 0.0);
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
    frd.psiDot().ifPresent(rate -> heading.rate(rate, 0.0, measuredAt));
    if (frd instanceof InertialMeasurement inertial) {
      inertial.yawRate().ifPresent(rate -> heading.rate(rate, 0.0, measuredAt));
    }
    if (frd.xDot().isPresent() && heading.hasValue()) {
      boolean isTilted = micros - tiltMicros <= Clock.micros(tuning.staleAfter());
      Attitude attitude =
          new Attitude(isTilted ? phi : 0.0, isTilted ? theta : 0.0, heading.value());
      Point along =
          Point.of(frd.xDot().getAsDouble(), frd.yDot().orElse(0.0), frd.zDot().orElse(0.0));
      Point ned = attitude.nedFromFrd().times(along);
      double across = Math.hypot(ned.x(), ned.y()) * heading.sigma();
      double rateSigma = Math.hypot(frd.xDotSigma().orElse(USUAL_SIGMA_MPS), across);
      longitude.rate(ned.y(), rateSigma, measuredAt);
      latitude.rate(ned.x(), rateSigma, measuredAt);
      if (isTilted && frd.zDot().isPresent()) {
        altitude.rate(-ned.z(), 0.0, measuredAt);
      }
    }
  }

  private void takeGlobal(StateInformation sensed, long measuredAt) {
    double xSigma = sensed.xDotSigma().orElse(USUAL_SIGMA_MPS);
    double ySigma = sensed.yDotSigma().orElse(USUAL_SIGMA_MPS);
    sensed.xDot().ifPresent(rate -> longitude.rate(rate, xSigma, measuredAt));
    sensed.yDot().ifPresent(rate -> latitude.rate(rate, ySigma, measuredAt));
    sensed.zDot().ifPresent(rate -> altitude.rate(rate, 0.0, measuredAt));
    sensed.psiDot().ifPresent(rate -> heading.rate(rate, 0.0, measuredAt));
    if (sensed.phi().isPresent() && sensed.theta().isPresent()) {
      phi = sensed.phi().getAsDouble();
      theta = sensed.theta().getAsDouble();
      tiltMicros = measuredAt;
    }
    if (sensed.x().isPresent() && sensed.y().isPresent()) {
      pull(latitude, DEG_PER_M, sensed, StateField.Y, StateField.Y_SIGMA);
      double perM = DEG_PER_M / Math.cos(Math.toRadians(latitude.value()));
      pull(longitude, perM, sensed, StateField.X, StateField.X_SIGMA);
    }
    pull(altitude, 1.0, sensed, StateField.Z, StateField.Z_SIGMA);
    pull(heading, 1.0, sensed, StateField.PSI, StateField.PSI_SIGMA);
  }

  /** Pulls a channel toward a measured value, extrapolated to the state's time by its rate. */
  private void pull(
      PropagatedValue channel,
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
    double apart = measured.getAsDouble() + channel.moved(ageS, perUnit) - channel.value();
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
    altitude // a vehicle under water needs it to keep its depth
        .slope()
        .ifPresent(slope -> state.zDot(slope).zDotSigma(altitude.slopeSigma()));
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
      PropagatedValue channel,
      StateField value,
      StateField sigma,
      StateField rate) {
    if (channel.hasValue()) {
      state.number(value, channel.value());
      if (channel.sigma() > 0.0) {
        state.number(sigma, channel.sigma());
      }
    }
    if (channel.hasRate()) {
      state.number(rate, channel.rate());
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
