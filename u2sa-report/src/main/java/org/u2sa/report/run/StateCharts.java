package org.u2sa.report.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.report.page.Chart;
import org.u2sa.report.page.Trace;

/** Charts of the estimated state over time, compared with ground truth if known. */
final class StateCharts {
  private static final int MAX_ACTUATORS = 12;

  private final RunMap map;
  private final TruthTrack truth; // null if unknown
  private final double truthFromS;
  private final Trace eastError = new Trace("east");
  private final Trace northError = new Trace("north");
  private final Trace positionSigma = new Trace("position");
  private final Trace headingError = new Trace("heading");
  private final Trace headingSigma = new Trace("heading");
  private final Trace altitude = new Trace("estimated");
  private final Trace trueAltitude = new Trace("true");
  private final Trace speed = new Trace("over ground");
  private final Trace crossTrack = new Trace("estimated");
  private final Trace trueCrossTrack = new Trace("true");
  private final Map<String, Trace> actuators = new LinkedHashMap<>();
  private String target = ""; // goal being pursued
  private Point legFrom; // null before the first goal is reached
  private Point lastAt;

  /** Truth may be null; it starts {@code truthFromS} seconds into the recording. */
  StateCharts(RunMap map, TruthTrack truth, double truthFromS) {
    this.map = map;
    this.truth = truth;
    this.truthFromS = truthFromS;
  }

  /** Adds an estimate measured at a time of the recording [s]. */
  void take(double timeS, StateInformation state) {
    Optional<Point> at = map.take(timeS, state);
    if (at.isEmpty()) {
      return;
    }
    lastAt = at.get();
    state.z().ifPresent(z -> altitude.add(timeS, z));
    if (state.xDot().isPresent() && state.yDot().isPresent()) {
      speed.add(timeS, Math.hypot(state.xDot().getAsDouble(), state.yDot().getAsDouble()));
    }
    if (state.xSigma().isPresent() && state.ySigma().isPresent()) {
      positionSigma.add(
          timeS, Math.max(state.xSigma().getAsDouble(), state.ySigma().getAsDouble()));
    }
    state.psiSigma().ifPresent(sigma -> headingSigma.add(timeS, Math.toDegrees(sigma)));
    offTrack(lastAt).ifPresent(d -> crossTrack.add(timeS, d));
    if (truth != null) {
      truth.at(timeS - truthFromS).ifPresent(really -> compare(timeS, state, lastAt, really));
    }
  }

  private void compare(double timeS, StateInformation state, Point at, TruthTrack.Place really) {
    Point trueAt = map.place(really.at()).orElseThrow();
    eastError.add(timeS, at.x() - trueAt.x());
    northError.add(timeS, at.y() - trueAt.y());
    trueAltitude.add(timeS, really.at().altitudeM());
    offTrack(trueAt).ifPresent(d -> trueCrossTrack.add(timeS, d));
    state
        .psi()
        .ifPresent(
            psi ->
                headingError.add(
                    timeS,
                    Math.toDegrees(Math.IEEEremainder(psi - really.headingRad(), 2 * Math.PI))));
  }

  void take(GoalList goals) {
    map.take(goals);
    for (GoalInformation goal : goals.goals()) {
      if (!goal.completed() && !goal.abandoned()) {
        if (!goal.uid().equals(target)) {
          legFrom = map.goal(target).orElse(lastAt);
          target = goal.uid();
        }
        return;
      }
    }
    target = "";
  }

  /**
   * Cross-track error: distance to the line from the previous to the current goal [m], positive to
   * the right.
   */
  private Optional<Double> offTrack(Point at) {
    Optional<Point> to = map.goal(target);
    if (legFrom == null || to.isEmpty()) {
      return Optional.empty();
    }
    double x = to.get().x() - legFrom.x();
    double y = to.get().y() - legFrom.y();
    double length = Math.hypot(x, y);
    return length == 0.0
        ? Optional.empty()
        : Optional.of(((at.x() - legFrom.x()) * y - (at.y() - legFrom.y()) * x) / length);
  }

  void take(double timeS, PercentageCommand command) {
    if (actuators.size() < MAX_ACTUATORS || actuators.containsKey(command.actuatorName())) {
      actuators
          .computeIfAbsent(command.actuatorName(), Trace::new)
          .add(timeS, command.percentage());
    }
  }

  /** Errors for tables; null if the truth is unknown. */
  Double positionErrorRms() {
    return eastError.size() == 0
        ? null
        : Trace.rounded(Math.hypot(eastError.rootMeanSquare(), northError.rootMeanSquare()));
  }

  Trace crossTrack() {
    return trueCrossTrack.size() > 0 ? trueCrossTrack : crossTrack;
  }

  List<Chart> charts() {
    List<Chart> all = new ArrayList<>();
    all.add(
        new Chart(
            "Position error, and 2σ as estimated",
            "m",
            List.of(eastError, northError),
            positionSigma));
    all.add(
        new Chart(
            "Heading error, and 2σ as estimated", "deg", List.of(headingError), headingSigma));
    all.add(
        new Chart(
            "Cross-track error between goals (right +)",
            "m",
            List.of(crossTrack, trueCrossTrack),
            null));
    all.add(new Chart("Altitude", "m", List.of(altitude, trueAltitude), null));
    all.add(new Chart("Speed", "m/s", List.of(speed), null));
    all.add(new Chart("Actuators", "%", new ArrayList<>(actuators.values()), null));
    return all;
  }
}
