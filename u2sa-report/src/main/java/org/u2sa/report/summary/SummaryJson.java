package org.u2sa.report.summary;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.interfaces.JsonText;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.ObstacleResult;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.WaypointResult;

/** Writes {@code summary.json} of one run, keys in a fixed order. */
final class SummaryJson {

  /** Waypoint radius of IGVC's qualification, independent of the mission [m]. */
  private static final double QUALIFYING_M = 2.0;

  private final Map<String, String> absent = new LinkedHashMap<>();
  private final SummaryNumbers json = new SummaryNumbers(absent, "");

  private SummaryJson() {}

  static String text(Domain domain, RunDetails facts, RunScore score) {
    return new SummaryJson().run(domain, facts, score);
  }

  private String run(Domain domain, RunDetails facts, RunScore score) {
    int planned = score.waypoints().size();
    json.put("demo", facts.demo())
        .put("seed", facts.seed())
        .put("simulator", facts.simulator())
        .put("success", score.success())
        .put("waypoints", planned)
        .put("waypointsCaptured", score.captured());
    if (domain == Domain.GROUND) {
      json.put("waypointsWithin2M", score.within(QUALIFYING_M));
    }
    json.put("goals", facts.goals().orElse(planned))
        .put("goalsCompleted", facts.goalsCompleted().orElse(score.captured()))
        .put("perWaypoint", score.waypoints().stream().map(w -> waypoint(domain, w)).toList());
    String noStraight = "no straight between waypoints was " + domain.moved();
    json.number("crossTrackRmsM", score.crossTrackRmsM(), noStraight)
        .number("crossTrackRmsWholeLegsM", score.crossTrackRmsWholeLegsM(), noStraight)
        .number("settlingDistanceM", domain.settlingDistanceM());
    if (score.flight().isPresent()) {
      flight(score.flight().get());
      json.put("crashed", score.outcome().crashed()).put("stalled", score.outcome().stalled());
    }
    if (!score.obstacles().isEmpty()) {
      json.put("obstacles", score.obstacles().stream().map(this::obstacle).toList());
    }
    score.outcome().counts().forEach(json::put);
    score.outcome().figures().forEach(json::number);
    OptionalDouble rate =
        facts.wallSeconds() > 0.0
            ? OptionalDouble.of(score.simSeconds() / facts.wallSeconds())
            : OptionalDouble.empty();
    return json.put("contacts", score.outcome().contacts())
        .put("violations", score.outcome().violations().size())
        .put("violationDetails", score.outcome().violations())
        .number("simSeconds", score.simSeconds())
        .number("wallSeconds", facts.wallSeconds())
        .number("simSecondsPerSecond", rate, "no wall time was measured")
        .text();
  }

  private JsonText waypoint(Domain domain, WaypointResult result) {
    String never = "was never the target";
    SummaryNumbers waypoint =
        new SummaryNumbers(absent, result.waypoint().name())
            .put("name", result.waypoint().name())
            .number("missM", result.missM(), never);
    if (domain == Domain.AIR) {
      waypoint.number(
          "altitudeErrorM",
          result.altitudeErrorM(),
          result.missM().isPresent() ? "has no planned altitude" : never);
    }
    return waypoint
        .number("timeS", result.timeS(), never)
        .put("captured", result.captured())
        .json();
  }

  private void flight(FlightFigures score) {
    String noLevel = "no leg between waypoints of equal altitude was flown";
    String noFlight = "the vehicle did not take off";
    json.number("altitudeRmsM", score.altitudeRmsM(), noLevel)
        .number("altitudeMaxErrorM", score.altitudeMaxErrorM(), noLevel)
        .number("maxBankDeg", score.maxBankDeg(), noFlight)
        .number("minAirspeedMps", score.minAirspeedMps(), noFlight)
        .put("tookOff", score.tookOff());
  }

  private JsonText obstacle(ObstacleResult result) {
    return new SummaryNumbers(absent, result.name())
        .put("name", result.name())
        .put("moves", result.moves())
        .number("leastDistanceM", result.leastM())
        .number("timeS", result.timeS())
        .put("touched", result.touched())
        .json();
  }
}
