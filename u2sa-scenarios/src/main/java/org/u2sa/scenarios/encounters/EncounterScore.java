package org.u2sa.scenarios.encounters;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.planning.rightofway.Rule;
import org.u2sa.scenarios.encounters.EncounterCase.Vessel;

/**
 * Judges a case by ground truth: distance, rule, early and clear action. The ideas and the form of
 * the score follow Woerner, Benjamin, Novitzky, Leonard: Quantifying protocol evaluation for
 * autonomous collision avoidance, Autonomous Robots 43, 2019; its formulas are in
 * docs/right-of-way.md.
 */
final class EncounterScore {
  private static final double PASSING_M = 20.0; // between circles around both
  private static final double VESSEL_M = 2.1;
  private static final double BOAT_M = 1.0;

  /** Required distance of the centres [m]. */
  static final double REQUIRED_M = PASSING_M + VESSEL_M + BOAT_M;

  private static final double NEAR =
      3.0; // multiple of the required distance within which the passing side matters
  private static final double GIVE_WAY_S = 120.0;
  private static final double EARLY_S = 60.0; // minimum time before the closest point
  private static final double STAND_ON_S = 60.0;
  private static final double STAND_ON_RANGES = 1.5;
  private static final double TOLERANCE_S = 5.0;
  private static final double APPARENT_RAD = Math.toRadians(30.0);
  private static final double ACTS_RAD = Math.toRadians(10.0);
  private static final double SLOW = 0.8;
  private static final double HALF = 0.55;
  private static final double STEADY_AFTER_S = 15.0;

  private final EncounterCase encounter;
  private final Map<String, Passage> passages = new LinkedHashMap<>();
  private double actionS = Double.NaN;
  private boolean actsToPort;
  private double
      turnRad; // largest course change in the direction of the first action, positive to starboard
  private double slowest = 1.0; // lowest fraction of the speed

  /** Record of passing one vessel. */
  private static final class Passage {
    private final Vessel vessel;
    private String applied = "";
    private double nearestM = Double.POSITIVE_INFINITY;
    private boolean isToStarboard; // at the closest point
    private double lastAcrossM = Double.NaN;
    private boolean crossedAhead;
    private double actionM = Double.NaN; // range at the boat's action

    Passage(Vessel vessel) {
      this.vessel = vessel;
    }
  }

  EncounterScore(EncounterCase encounter) {
    this.encounter = encounter;
    encounter.vessels().forEach(each -> passages.put(each.uid(), new Passage(each)));
  }

  /**
   * Processes the boat's true motion.
   *
   * @param timeS time of the case [s]
   * @param courseRad course over ground, clockwise from north
   */
  void see(double timeS, double northM, double eastM, double courseRad, double speedMps) {
    boolean isSteady = timeS > STEADY_AFTER_S;
    double change = isSteady ? Math.IEEEremainder(courseRad, 2.0 * Math.PI) : 0.0;
    double share = isSteady ? speedMps / EncounterCase.OWN_MPS : 1.0;
    slowest = Math.min(slowest, share);
    if (Double.isNaN(actionS) && (Math.abs(change) > ACTS_RAD || share < SLOW)) {
      actionS = timeS;
      actsToPort = change < -ACTS_RAD;
    }
    if (share > 0.2 && !Double.isNaN(actionS)) {
      turnRad = actsToPort ? Math.min(turnRad, change) : Math.max(turnRad, change);
    }
    for (Passage each : passages.values()) {
      double north = each.vessel.northAtM(timeS) - northM;
      double east = each.vessel.eastAtM(timeS) - eastM;
      double range = Math.hypot(north, east);
      if (timeS == actionS) {
        each.actionM = range;
      }
      if (range < each.nearestM) {
        each.nearestM = range;
        each.isToStarboard = Math.cos(courseRad) * east - Math.sin(courseRad) * north > 0.0;
      }
      double course = each.vessel.courseRad();
      double across = Math.cos(course) * east - Math.sin(course) * north;
      double ahead = -(Math.cos(course) * north + Math.sin(course) * east);
      if (across * each.lastAcrossM < 0.0 && ahead > 0.0 && ahead < NEAR * REQUIRED_M) {
        each.crossedAhead = true;
      }
      each.lastAcrossM = across;
    }
  }

  /** Processes the planner's remark about all encounters, from its health report. */
  void hear(String remark) {
    for (Passage each : passages.values()) {
      for (Rule rule : Rule.values()) {
        if (each.applied.isEmpty() && remark.contains(each.vessel.uid() + "\": " + rule)) {
          each.applied = rule.name();
        }
      }
    }
  }

  private static boolean isSurely(Passage passage, Set<Rule> rules) {
    return rules.containsAll(passage.vessel.expected());
  }

  /** Broken rules of the case, one sentence each. */
  List<String> violations() {
    List<String> all = new ArrayList<>();
    boolean mustGiveWay = false;
    for (Passage each : passages.values()) {
      Vessel vessel = each.vessel;
      boolean givesWay = vessel.expected().stream().allMatch(Rule::givesWay);
      mustGiveWay |= givesWay;
      if (each.nearestM < REQUIRED_M) {
        all.add(String.format(Locale.ROOT, "%s passed at %.1f m", vessel.uid(), each.nearestM));
      }
      if (!vessel.expected().stream().map(Enum::name).toList().contains(each.applied)) {
        all.add(vessel.uid() + ": rule applied: " + each.applied);
      }
      if (isSurely(each, Set.of(Rule.HEAD_ON))
          && each.isToStarboard
          && each.nearestM < NEAR * REQUIRED_M) {
        all.add(vessel.uid() + " was not passed port to port");
      }
      if (isSurely(each, Set.of(Rule.CROSSING_GIVE_WAY)) && each.crossedAhead) {
        all.add(vessel.uid() + ": the boat crossed ahead of it");
      }
      if (givesWay && !(beforeS(vessel) >= EARLY_S)) {
        all.add(
            String.format(
                Locale.ROOT, "%s: first action %.0f s before", vessel.uid(), beforeS(vessel)));
      }
    }
    boolean isSeen = Math.abs(turnRad) >= APPARENT_RAD || slowest <= HALF;
    if (mustGiveWay && !isSeen) {
      all.add(String.format(Locale.ROOT, "course changed by only %.0f°", Math.toDegrees(turnRad)));
    }
    if (actsToPort && (meetsHeadOn() || crossesOnly())) {
      all.add("the boat turned to port");
    }
    if (standsOnOnly() && actedEarly()) {
      all.add("the boat acted while it still had to stand on");
    }
    return all;
  }

  private boolean meetsHeadOn() {
    return passages.values().stream().anyMatch(each -> isSurely(each, Set.of(Rule.HEAD_ON)));
  }

  /** Whether no vessel overtakes or is overtaken, when either side may be open. */
  private boolean crossesOnly() {
    Set<Rule> crossing = Set.of(Rule.CROSSING_STAND_ON, Rule.CROSSING_GIVE_WAY);
    return passages.values().stream().allMatch(each -> isSurely(each, crossing));
  }

  private boolean standsOnOnly() {
    return passages.values().stream()
        .allMatch(each -> each.vessel.expected().stream().noneMatch(Rule::givesWay));
  }

  private boolean actedEarly() {
    return passages.values().stream()
        .allMatch(
            each ->
                beforeS(each.vessel) > STAND_ON_S + TOLERANCE_S
                    && each.actionM > 1.2 * STAND_ON_RANGES * REQUIRED_M);
  }

  /** Time from the first action to the closest point of approach without action [s]. */
  private double beforeS(Vessel vessel) {
    return vessel.closestS() - actionS;
  }

  private double score(Passage passage) {
    double safety =
        Math.max(
            0.0,
            Math.min(
                1.0, (passage.nearestM - VESSEL_M - BOAT_M) / (REQUIRED_M - VESSEL_M - BOAT_M)));
    if (!passage.vessel.expected().stream().allMatch(Rule::givesWay)) {
      return safety;
    }
    double unseen = Math.max(0.0, 1.0 - Math.abs(turnRad) / APPARENT_RAD);
    if (slowest <= HALF) {
      unseen = 0.0;
    }
    if (Double.isNaN(actionS)) {
      return 0.0;
    }
    double late = Math.max(0.0, Math.min(1.0, 1.0 - beforeS(passage.vessel) / GIVE_WAY_S));
    return safety * (1.0 - unseen) * (1.0 - late);
  }

  /** Mean score of all vessels, 0 to 1. */
  double score() {
    return passages.values().stream().mapToDouble(this::score).average().orElse(1.0);
  }

  /** Lowest range of any vessel [m]. */
  double nearestM() {
    return passages.values().stream().mapToDouble(each -> each.nearestM).min().orElse(0.0);
  }

  static String header() {
    return String.format(
        Locale.ROOT,
        "%-14s %-9s %-18s %-18s %7s %8s %7s %6s %6s %6s",
        "case",
        "vessel",
        "rule expected",
        "rule applied",
        "range m",
        "required",
        "first s",
        "turn",
        "speed",
        "score");
  }

  /** A line for each vessel: seconds count from the first action to the closest point. */
  List<String> lines() {
    return passages.values().stream().map(this::line).collect(Collectors.toList());
  }

  private String line(Passage each) {
    return String.format(
        Locale.ROOT,
        "%-14s %-9s %-18s %-18s %7.1f %8.1f %7.0f %5.0f° %5.0f%% %6.2f",
        encounter.name(),
        each.vessel.uid(),
        each.vessel.expected().stream().map(Enum::name).collect(Collectors.joining("|")),
        each.applied.isEmpty() ? "-" : each.applied,
        each.nearestM,
        REQUIRED_M,
        beforeS(each.vessel),
        Math.toDegrees(turnRad),
        100.0 * slowest,
        score(each));
  }
}
