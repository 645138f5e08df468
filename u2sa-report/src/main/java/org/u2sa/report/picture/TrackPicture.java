package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.TrackSample;

/**
 * Draws a run on one page: facts and results, the map, and a quantity over time (altitude of
 * aircraft, depth of submarines, cross-track error of others).
 */
public final class TrackPicture {
  public static final int WIDTH = 1600;
  public static final int HEIGHT = 1200;

  private static final Rectangle2D MAP =
      new Rectangle2D.Double(ChartStyle.LEFT, 118.0, 1480.0, 672.0);
  private static final Rectangle2D PROFILE =
      new Rectangle2D.Double(ChartStyle.LEFT, 870.0, 1480.0, 240.0);
  private static final double LEGEND = 30.0; // px

  private TrackPicture() {}

  public static String title(RunDetails facts, RunScore score) {
    return String.format(
        Locale.ROOT, "%s, seed %d: %s", facts.demo(), facts.seed(), facts.verdict(score));
  }

  public static void draw(
      Graphics2D graphics,
      RunDetails facts,
      RunPlan plan,
      RunScore score,
      List<TrackSample> track) {
    graphics.setPaint(ChartStyle.PAPER);
    graphics.fill(new Rectangle2D.Double(0.0, 0.0, WIDTH, HEIGHT));
    String alarm = alarm(facts, score);
    int up = alarm.isEmpty() ? 0 : 12;
    text(graphics, 58 - up, title(facts, score), ChartStyle.TEXT, ChartStyle.font(Font.BOLD, 34));
    text(
        graphics,
        92 - up,
        subtitle(facts, plan.domain(), score),
        ChartStyle.MUTED,
        ChartStyle.font(Font.PLAIN, 19));
    Font bold = ChartStyle.font(Font.BOLD, 19);
    text(graphics, 106, ChartStyle.fitted(alarm, bold, MAP.getWidth()), ChartStyle.MISSED, bold);
    Quantity colour = Quantity.onMap(plan, track);
    MapChart.of(plan, track, score, colour, MAP).draw(graphics, withAxes(MAP, 0.0));
    ProfileChart.of(plan, track, score, Quantity.overTime(plan, track), colour, PROFILE)
        .draw(graphics, withAxes(PROFILE, LEGEND));
  }

  /** Reasons why a run failed, apart from waypoints; empty if there are none. */
  static String alarm(RunDetails facts, RunScore score) {
    if (score.success()) {
      return "";
    }
    List<String> reasons = new ArrayList<>();
    if (score.outcome().crashed()) {
      reasons.add("CRASHED");
    }
    if (score.outcome().stalled()) {
      reasons.add("STALLED");
    }
    reasons.addAll(score.outcome().violations());
    reasons.addAll(facts.interventions());
    return String.join("  \u00b7  ", reasons);
  }

  private static Rectangle2D withAxes(Rectangle2D plot, double legend) {
    return new Rectangle2D.Double(
        0.0,
        plot.getY(),
        plot.getMaxX() + ChartStyle.RIGHT,
        plot.getHeight() + ChartStyle.BELOW + legend);
  }

  private static void text(Graphics2D graphics, int y, String text, Color color, Font font) {
    graphics.setPaint(color);
    graphics.setFont(font);
    graphics.drawString(text, (int) ChartStyle.LEFT, y);
  }

  private static String subtitle(RunDetails facts, Domain domain, RunScore score) {
    List<String> parts = new ArrayList<>();
    String rms = domain == Domain.AIR ? "cross-track RMS %.1f m" : "cross-track RMS %.2f m";
    add(parts, rms, score.crossTrackRmsM());
    score
        .flight()
        .ifPresent(
            flight -> {
              add(parts, "altitude RMS %.1f m on level legs", flight.altitudeRmsM());
              add(parts, "bank up to %.0f\u00b0", flight.maxBankDeg());
            });
    parts.add(ChartStyle.clock(score.simSeconds()) + " min simulated");
    parts.add(facts.simulator());
    return String.join("  \u00b7  ", parts);
  }

  private static void add(List<String> parts, String pattern, OptionalDouble value) {
    if (value.isPresent()) {
      parts.add(String.format(Locale.ROOT, pattern, value.getAsDouble()));
    }
  }
}
