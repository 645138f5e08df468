package org.u2sa.scenarios.report;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Draws a run on one page: what it was and how it went, the map, and a quantity over time: the
 * altitude of aircraft, how far beside the line others were.
 */
final class TrackPicture {

  static final int WIDTH = 1600;
  static final int HEIGHT = 1200;

  private static final double LEFT = 80.0;
  private static final double RIGHT = 1560.0;
  private static final Rectangle2D.Double MAP =
      new Rectangle2D.Double(LEFT, 118.0, RIGHT - LEFT, 672.0);
  private static final Rectangle2D.Double PROFILE =
      new Rectangle2D.Double(LEFT, 890.0, RIGHT - LEFT, 250.0);

  private TrackPicture() {}

  static String title(RunReport.Facts facts, RunScore score) {
    return String.format(
        Locale.ROOT,
        "%s, seed %d: %d of %d waypoints captured",
        facts.demo(),
        facts.seed(),
        score.captured(),
        score.waypoints().size());
  }

  static void draw(
      Drawing drawing,
      RunReport.Facts facts,
      RunPlan plan,
      RunScore score,
      List<TrackSample> track) {
    Quantity colour = Quantity.onMap(plan, track);
    drawing.draw(new Rectangle2D.Double(0.0, 0.0, WIDTH, HEIGHT), Ink.PAPER, null);
    drawing.text(LEFT, 58.0, title(facts, score), Ink.TITLE);
    String alarm = alarm(score);
    drawing.text(LEFT, 92.0, alarm, Ink.ALARM);
    drawing.text(
        LEFT + Ink.ALARM.widthOf(alarm), 92.0, subtitle(facts, plan.domain(), score), Ink.SUBTITLE);
    new MapPanel(drawing, MAP, plan, track, score, colour).draw();
    new ProfilePanel(drawing, PROFILE, plan, track, score, Quantity.overTime(plan, track), colour)
        .draw();
  }

  private static String alarm(RunScore score) {
    return (score.outcome().crashed() ? "CRASHED    " : "")
        + (score.outcome().stalled() ? "STALLED    " : "");
  }

  private static String subtitle(RunReport.Facts facts, Domain domain, RunScore score) {
    List<String> parts = new ArrayList<>();
    String rms = domain == Domain.AIR ? "cross-track RMS %.1f m" : "cross-track RMS %.2f m";
    add(parts, rms, score.crossTrackRmsM());
    score.flight().ifPresent(flight -> add(parts, flight));
    parts.add(ProfilePanel.clock(score.simSeconds()) + " min simulated");
    parts.add(facts.simulator());
    return String.join("  \u00b7  ", parts);
  }

  private static void add(List<String> parts, FlightFigures flight) {
    add(parts, "altitude RMS %.1f m on level legs", flight.altitudeRmsM());
    add(parts, "bank up to %.0f\u00b0", flight.maxBankDeg());
  }

  private static void add(List<String> parts, String pattern, OptionalDouble value) {
    if (value.isPresent()) {
      parts.add(String.format(Locale.ROOT, pattern, value.getAsDouble()));
    }
  }
}
