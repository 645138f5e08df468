package org.u2sa.trials.simulate;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.trials.run.TruthObserver;

/**
 * Scores a run of any vehicle: goals by their completion, contacts, zones, and the published state
 * against the truth.
 */
final class EstimateScorer implements TruthObserver.Scorer {
  private static final double SIGMAS = 3.0;
  private static final double US_PER_S = 1e6;

  private final RunningVehicle run;
  private final Geodetic origin;
  private final Clock clock;
  private final Set<String> goals;
  private final int unplaced;
  private final ZoneWatch zones;
  private final Errors position = new Errors();
  private final Errors altitude = new Errors();
  private final Errors heading = new Errors();
  private double squares; // sum of squared distances from the true position [m²]
  private double farthestM;

  /** Errors of a quantity relative to the standard deviations that the state claims. */
  private static final class Errors {
    private double squares;
    private double largest;
    private int count;
    private int claims;
    private int within;

    void add(double error, OptionalDouble sigma) {
      squares += error * error;
      largest = Math.max(largest, Math.abs(error));
      count++;
      if (sigma.isPresent()) {
        claims++;
        within += Math.abs(error) <= SIGMAS * sigma.getAsDouble() ? 1 : 0;
      }
    }

    double rms() {
      return Math.sqrt(squares / count);
    }
  }

  /**
   * @param run the vehicle
   * @param origin origin of local frames
   * @param clock the run's
   * @param goals names of the mission's goals
   * @param unplaced number of those that are not waypoints of the plan
   */
  EstimateScorer(
      RunningVehicle run, Geodetic origin, Clock clock, Set<String> goals, int unplaced) {
    this.run = run;
    this.origin = origin;
    this.clock = clock;
    this.goals = goals;
    this.unplaced = unplaced;
    zones = new ZoneWatch(run.vehicle().world().zones());
  }

  @Override
  public void see(VehicleTruth truth) {
    zones.see(truth);
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(Channels.STATE);
  }

  @Override
  public Set<String> required() {
    return goals;
  }

  @Override
  public boolean heard(U2SAData data) {
    if (!(data instanceof StateInformation state)) {
      return false;
    }
    ReferenceFrame frame = state.referenceFrame();
    boolean isPlace =
        frame.isEarth()
            || frame.equals(ReferenceFrame.LOCAL_ENU)
            || frame.equals(ReferenceFrame.LOCAL_NED);
    if (isPlace && (!frame.isEarth() || state.x().isPresent() && state.y().isPresent())) {
      StateInformation ned = state.in(ReferenceFrame.LOCAL_NED, origin);
      VehicleTruth truth = run.at(clock.micros());
      compare(ned, state.timestamp().orElse(clock.micros()), truth);
      headingError(ned, truth.headingRad(), origin)
          .ifPresent(error -> heading.add(error, state.psiSigma()));
    }
    return true;
  }

  /**
   * Heading error [rad, -π…π]. Ground truth is relative to the origin's north, a geographic state
   * to north at the vehicle: near a pole they differ by degrees within metres.
   *
   * @param trueRad heading, clockwise from the origin's north [rad]
   */
  static OptionalDouble headingError(StateInformation state, double trueRad, Geodetic origin) {
    OptionalDouble psi = state.in(ReferenceFrame.LOCAL_NED, origin).psi();
    return psi.isPresent()
        ? OptionalDouble.of(Math.IEEEremainder(psi.getAsDouble() - trueRad, 2.0 * Math.PI))
        : psi;
  }

  /**
   * @param ned north, east, down
   * @param atMicros time of the state
   */
  private void compare(StateInformation ned, long atMicros, VehicleTruth truth) {
    if (ned.x().isEmpty() || ned.y().isEmpty()) {
      return;
    }
    double ageS = Math.max(0.0, (clock.micros() - atMicros) / US_PER_S);
    Point then =
        Point.of(
            truth.position().x() - ageS * truth.velocity().x(),
            truth.position().y() - ageS * truth.velocity().y(),
            truth.position().z() - ageS * truth.velocity().z());
    double east = ned.y().getAsDouble() - then.x();
    double north = ned.x().getAsDouble() - then.y();
    position.add(east, ned.ySigma());
    position.add(north, ned.xSigma());
    double square = east * east + north * north;
    squares += square;
    farthestM = Math.max(farthestM, Math.sqrt(square));
    if (ned.z().isPresent()) {
      altitude.add(-ned.z().getAsDouble() - then.z(), ned.zSigma());
    }
  }

  @Override
  public RunOutcome outcome() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(RunOutcome.GOALS_WITHOUT_PLACE, unplaced);
    counts.putAll(zones.counts());
    return new RunOutcome(run.contacts().size(), false, zones.violations(), counts, figures());
  }

  private Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    if (position.count > 0) {
      figures.put("positionErrorRmsM", Math.sqrt(2.0 * squares / position.count));
      figures.put("positionErrorMaxM", farthestM);
    }
    if (altitude.count > 0) {
      figures.put("altitudeErrorRmsM", altitude.rms());
      figures.put("altitudeErrorMaxM", altitude.largest);
    }
    if (heading.count > 0) {
      figures.put("headingErrorRmsDeg", Math.toDegrees(heading.rms()));
      figures.put("headingErrorMaxDeg", Math.toDegrees(heading.largest));
    }
    run.read(clock.micros(), SimulatedVehicle::energyJ)
        .ifPresent(energy -> figures.put("energyJ", energy));
    int claims = position.claims + altitude.claims + heading.claims;
    if (claims > 0) {
      int within = position.within + altitude.within + heading.within;
      figures.put("stateWithin3Sigma", (double) within / claims);
    }
    figures.putAll(zones.figures());
    return figures;
  }
}
