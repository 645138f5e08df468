package org.u2sa.gcs.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.gcs.draw.Box;
import org.u2sa.gcs.draw.Canvas;

/** Draws a flight on one page: what it was and how it went, the map, the altitude profile. */
final class TrackPicture {

  static final int WIDTH = 1600;
  static final int HEIGHT = 1200;

  private static final double LEFT = 80.0;
  private static final double RIGHT = 1560.0;
  private static final Box MAP = new Box(LEFT, 118.0, RIGHT - LEFT, 672.0);
  private static final Box PROFILE = new Box(LEFT, 890.0, RIGHT - LEFT, 250.0);

  private TrackPicture() {}

  static String title(RunFacts facts, FlightScore score) {
    return String.format(
        Locale.ROOT,
        "%s, seed %d: %d of %d waypoints captured",
        facts.demo(),
        facts.seed(),
        score.captured(),
        score.waypoints().size());
  }

  static void draw(
      Canvas canvas, RunFacts facts, FlightPlan plan, FlightScore score, List<FlightSample> track) {
    AltitudeRange altitudes = AltitudeRange.of(plan, track);
    canvas.rectangle(new Box(0.0, 0.0, WIDTH, HEIGHT), Ink.PAPER, null);
    canvas.text(LEFT, 58.0, title(facts, score), Ink.TITLE);
    String alarm = alarm(score);
    canvas.text(LEFT, 92.0, alarm, Ink.ALARM);
    canvas.text(LEFT + Ink.ALARM.widthOf(alarm), 92.0, subtitle(facts, score), Ink.SUBTITLE);
    new MapPanel(canvas, MAP, plan, track, score, altitudes).draw();
    new ProfilePanel(canvas, PROFILE, plan, track, score, altitudes).draw();
  }

  private static String alarm(FlightScore score) {
    return (score.outcome().crashed() ? "CRASHED    " : "")
        + (score.outcome().stalled() ? "STALLED    " : "");
  }

  private static String subtitle(RunFacts facts, FlightScore score) {
    List<String> parts = new ArrayList<>();
    add(parts, "cross-track RMS %.1f m", score.crossTrackRmsM());
    add(parts, "altitude RMS %.1f m on level legs", score.altitudeRmsM());
    if (score.maxBankRad().isPresent()) {
      parts.add(
          String.format(
              Locale.ROOT,
              "bank up to %.0f\u00b0",
              Math.toDegrees(score.maxBankRad().getAsDouble())));
    }
    parts.add(ProfilePanel.clock(score.simSeconds()) + " min simulated");
    parts.add(facts.simulator());
    return String.join("  \u00b7  ", parts);
  }

  private static void add(List<String> parts, String pattern, OptionalDouble value) {
    if (value.isPresent()) {
      parts.add(String.format(Locale.ROOT, pattern, value.getAsDouble()));
    }
  }
}
