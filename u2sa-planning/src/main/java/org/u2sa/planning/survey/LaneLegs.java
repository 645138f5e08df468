package org.u2sa.planning.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanningPlane;

/** The lanes over a search area in the order of flight, each with a straight way before it. */
public final class LaneLegs {
  private static final int MAX_LANES = 120; // per pass; the rest is flown in the next one
  private static final double ACROSS_M = 10.0; // distance from its line at which a lane may begin
  private static final double NEAR_M = 2.0; // of its entry, where a vehicle may turn in place
  private static final double TURNED_RAD = Math.toRadians(30.0); // likewise, course error

  private LaneLegs() {}

  /**
   * How the vehicle flies.
   *
   * @param airspeedMps airspeed
   * @param radiusM radius of turns [m]; 0 if it turns in place
   * @param northMps northward velocity of the wind
   * @param eastMps eastward velocity of the wind
   */
  public record Wind(double airspeedMps, double radiusM, double northMps, double eastMps) {}

  /** A lane, and the way before it. */
  public static final class Leg {
    private final Lane lane;
    private final double leadInM;

    private Leg(Lane lane, double leadInM) {
      this.lane = lane;
      this.leadInM = leadInM;
    }

    /** Start of the way before the lane. */
    public Pose entry() {
      return lane.entry(leadInM);
    }

    public Pose end() {
      return lane.end();
    }

    /** The same lane in the other direction. */
    public Leg reversed() {
      return new Leg(lane.reversed(), leadInM);
    }

    /** Whether the vehicle flies along the lane's line, on the way before it or on it. */
    public boolean isEntered(double northM, double eastM, double courseRad) {
      double along = lane.alongM(northM, eastM);
      double turn = Math.abs(Math.IEEEremainder(courseRad - lane.courseRad(), 2.0 * Math.PI));
      return along > -leadInM - ACROSS_M
          && along < 0.0
          && turn < TURNED_RAD
          && Math.abs(lane.acrossM(northM, eastM)) < ACROSS_M;
    }

    /** Whether the vehicle is at the entry, in whatever direction. */
    public boolean isNear(double northM, double eastM) {
      return entry().distanceM(northM, eastM) < NEAR_M;
    }

    public boolean isPassed(double northM, double eastM) {
      return lane.alongM(northM, eastM) >= lane.lengthM();
    }

    /** A point on the lane's line ahead of the vehicle, possibly beyond its end. */
    public Pose ahead(double northM, double eastM, double aheadM) {
      double along = lane.alongM(northM, eastM) + aheadM;
      return new Pose(lane.northAt(along), lane.eastAt(along), lane.courseRad());
    }

    /** Whether all of the lane's cells have been seen. */
    public boolean isSeen(CoverageLedger ledger, double resolutionM) {
      for (int cell : lane.cells()) {
        if (!ledger.isSeen(cell, resolutionM)) {
          return false;
        }
      }
      return true;
    }
  }

  /** The record of an area. */
  public static Optional<CoverageLedger> ledger(SearchArea area, List<ObjectDescription> objects) {
    return LedgerCells.of(area, objects);
  }

  /** Altitude at which a level area is flown over [m above mean sea level]. */
  public static double altitudeM(SearchArea area, SurveyVariables survey) {
    double height = survey.surveyHeight() * area.resolution() * survey.surveyFocalLength();
    double highest = area.highest().orElse(Double.POSITIVE_INFINITY);
    double lowest = area.lowest().orElse(Double.NEGATIVE_INFINITY);
    return Math.max(lowest, Math.min(highest, area.ground() + height));
  }

  /** Why the camera cannot image an area at its resolution; empty if it can. */
  public static Optional<String> fault(
      SearchArea area, CoverageLedger ledger, SurveyVariables survey) {
    double height = altitudeM(area, survey) - area.ground();
    double pixelM = height / survey.surveyFocalLength();
    double shownM = pixelM * survey.surveyPixels();
    if (pixelM > area.resolution()) {
      return Optional.of(
          String.format(
              Locale.ROOT,
              "from %.0f m above the ground a pixel covers %.3f m; expected up to %.3f m",
              height,
              pixelM,
              area.resolution()));
    }
    return ledger.cell() < shownM
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "cells of %.1f m do not fit into an image of %.1f m; expected a smaller area or a "
                    + "coarser resolution",
                ledger.cell(),
                shownM));
  }

  /** Lanes over the cells missing in the record. */
  public static List<Leg> over(
      SearchArea area,
      CoverageLedger ledger,
      PlanningPlane plane,
      Pose from,
      Wind wind,
      SurveyVariables survey) {
    double height = altitudeM(area, survey) - area.ground();
    double shown = height * survey.surveyPixels() / survey.surveyFocalLength();
    LaneLayout.Flight flight =
        new LaneLayout.Flight(
            shown * (1.0 - survey.surveyOverlap()),
            wind.radiusM(),
            wind.airspeedMps(),
            wind.northMps(),
            wind.eastMps());
    List<Lane> all = LaneLayout.best(LedgerCells.missing(ledger, area, plane), flight);
    List<Lane> lanes = all.subList(0, Math.min(MAX_LANES, all.size()));
    List<Leg> legs = new ArrayList<>();
    for (Lane lane : LaneOrder.of(lanes, from, wind.radiusM(), survey.surveyLeadIn())) {
      legs.add(new Leg(lane, survey.surveyLeadIn()));
    }
    return legs;
  }
}
