package org.u2sa.scenarios.report;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Canvas.Pixel;
import org.u2sa.gcs.draw.LabelPlacer;
import org.u2sa.gcs.draw.PixelBox;
import org.u2sa.gcs.draw.Stroke;
import org.u2sa.gcs.draw.TextStyle.Anchor;
import org.u2sa.gcs.draw.Ticks;

/**
 * Draws the map: grid, runway, fence, planned line, track, waypoints with their capture circles and
 * names.
 */
final class MapPanel {

  private static final double M_PER_KM = 1000.0;
  private static final double KM_FROM_M = 1000.0; // smaller maps are labelled in metres
  private static final double LEAST_RUNWAY_WIDTH = 11.0; // px
  private static final double LINE_WIDTH = 3.4;
  private static final double LEADER_FROM =
      14.0; // a label farther from its waypoint gets a leader line [px]
  private static final double HOME_RADIUS = 7.0; // px
  private static final double LARGEST_WHOLE_CIRCLE = 25.0; // px
  private static final double NAME_HEIGHT = 18.0;
  private static final int MOST_NAMES = 30; // with more waypoints, numbers alone

  private final Canvas canvas;
  private final RunPlan plan;
  private final List<WaypointSign> signs;
  private final MapView view;
  private final TrackLine line;
  private final Quantity colour;
  private final double gridUnitM;

  MapPanel(
      Canvas canvas,
      PixelBox frame,
      RunPlan plan,
      List<TrackSample> track,
      RunScore score,
      Quantity colour) {
    this.canvas = canvas;
    this.plan = plan;
    signs = WaypointSign.of(score.waypoints());
    view = MapView.of(plan, track, frame);
    line = new TrackLine(track, colour, sample -> view.pixel(view.plane().place(sample)));
    this.colour = colour;
    boolean small =
        plan.domain() == Domain.GROUND && Math.max(view.widthM(), view.heightM()) < KM_FROM_M;
    gridUnitM = small ? 1.0 : M_PER_KM;
  }

  void draw() {
    canvas.rectangle(view.frame(), Ink.PANEL, null);
    grid();
    canvas.clipped(
        view.frame(),
        () -> {
          captureCircles();
          canvas.polyline(fence(), Stroke.dashed(Ink.MISSED, 2.0, 5.0));
          canvas.polyline(planned(), Stroke.dashed(Ink.PLANNED, 2.0, 7.0));
          plan.home().ifPresent(this::runway);
          line.draw(canvas, LINE_WIDTH);
          signs.forEach(
              sign -> WaypointMark.draw(canvas, view.pixel(sign.waypoint()), sign.captured()));
        });
    canvas.rectangle(view.frame(), null, Ink.FRAME);
    MapFurniture furniture = new MapFurniture(canvas, view);
    LabelPlacer placer = new LabelPlacer(view.frame());
    furniture.boxes().forEach(placer::avoid);
    names(placer);
    furniture.draw(colour);
  }

  private void grid() {
    PixelBox frame = view.frame();
    Ticks ticks = Ticks.between(0.0, Math.max(view.widthM(), view.heightM()) / gridUnitM, 12);
    for (double tick :
        Ticks.every(
                ticks.step(), view.westM() / gridUnitM, (view.westM() + view.widthM()) / gridUnitM)
            .values()) {
      double x = view.x(tick * gridUnitM);
      canvas.line(x, frame.y(), x, frame.bottom(), Ink.GRID);
      canvas.text(x, frame.bottom() + 19.0, ticks.label(tick), Ink.TICK.anchored(Anchor.MIDDLE));
    }
    for (double tick :
        Ticks.every(
                ticks.step(),
                view.southM() / gridUnitM,
                (view.southM() + view.heightM()) / gridUnitM)
            .values()) {
      double y = view.y(tick * gridUnitM);
      canvas.line(frame.x(), y, frame.right(), y, Ink.GRID);
      canvas.text(frame.x() - 8.0, y + 5.0, ticks.label(tick), Ink.TICK.anchored(Anchor.END));
    }
    String origin = plan.home().isPresent() ? "home" : "the first waypoint";
    canvas.text(
        frame.right(),
        frame.bottom() + 40.0,
        (gridUnitM == 1.0 ? "m" : "km") + " east and north of " + origin,
        Ink.TICK.anchored(Anchor.END));
  }

  /** Once around. */
  private List<Pixel> fence() {
    List<Pixel> line = new ArrayList<>();
    for (RunPlan.Corner corner : plan.fence()) {
      line.add(view.pixel(view.plane().place(corner.longitudeDeg(), corner.latitudeDeg())));
    }
    if (!line.isEmpty()) {
      line.add(line.get(0));
    }
    return line;
  }

  private List<Pixel> planned() {
    List<Pixel> line = new ArrayList<>();
    plan.home()
        .ifPresent(
            home ->
                line.add(view.pixel(view.plane().place(home.longitudeDeg(), home.latitudeDeg()))));
    plan.waypoints().forEach(waypoint -> line.add(view.pixel(waypoint)));
    return line;
  }

  private void runway(StartPlace home) {
    PlotPlane.Place start = view.plane().place(home.longitudeDeg(), home.latitudeDeg());
    Pixel from = view.pixel(start);
    if (home.runwayLengthM().isPresent()) {
      double length = home.runwayLengthM().getAsDouble();
      Pixel to =
          view.pixel(
              new PlotPlane.Place(
                  start.eastM() + length * Math.sin(home.headingRad()),
                  start.northM() + length * Math.cos(home.headingRad())));
      double width = Math.max(LEAST_RUNWAY_WIDTH, 30.0 * view.pixelsPerMetre());
      canvas.line(from.x(), from.y(), to.x(), to.y(), Stroke.solid(Ink.RUNWAY, width));
      canvas.line(from.x(), from.y(), to.x(), to.y(), Stroke.dashed(Ink.PAPER, 1.2, 6.0));
    }
    canvas.rectangle(
        new PixelBox(from.x() - 6.0, from.y() - 6.0, 12.0, 12.0),
        Ink.RUNWAY,
        Stroke.solid(Ink.PAPER, 1.5));
  }

  private void captureCircles() {
    for (WaypointSign sign : signs) {
      Pixel at = view.pixel(sign.waypoint());
      double radius = sign.waypoint().captureRadiusM() * view.pixelsPerMetre();
      canvas.circle(
          at.x(),
          at.y(),
          radius,
          sign.captured() ? Ink.CAPTURED_AREA : Ink.MISSED_AREA,
          Stroke.solid(sign.captured() ? Ink.CAPTURED : Ink.MISSED, 1.3));
    }
  }

  private void names(LabelPlacer placer) {
    placer.avoidLine(Densified.line(line.pixels()));
    placer.avoidLine(Densified.line(planned()));
    for (WaypointSign sign : signs) {
      Pixel at = view.pixel(sign.waypoint());
      double radius = signRadius(sign);
      placer.avoid(new PixelBox(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius));
    }
    boolean crowded = signs.size() > MOST_NAMES;
    for (WaypointSign sign : signs) {
      String name =
          crowded
              ? String.valueOf(sign.index() + 1)
              : WaypointNames.numbered(sign.index(), sign.waypoint());
      name(placer, view.pixel(sign.waypoint()), signRadius(sign), name);
    }
    plan.home()
        .ifPresent(
            home ->
                name(
                    placer,
                    view.pixel(view.plane().place(home.longitudeDeg(), home.latitudeDeg())),
                    HOME_RADIUS,
                    "home"));
  }

  /**
   * What a name should stay off: the whole capture circle while that is small, else the sign alone.
   */
  private double signRadius(WaypointSign sign) {
    double circle = sign.waypoint().captureRadiusM() * view.pixelsPerMetre();
    return Math.max(WaypointMark.RADIUS, circle <= LARGEST_WHOLE_CIRCLE ? circle : 0.0) + 1.0;
  }

  private void name(LabelPlacer placer, Pixel at, double radius, String name) {
    double width = Ink.LABEL.widthOf(name) + 4.0;
    PixelBox box = placer.place(at.x(), at.y(), radius, width, NAME_HEIGHT);
    double nearX = Math.max(box.x(), Math.min(box.right(), at.x()));
    double nearY = Math.max(box.y(), Math.min(box.bottom(), at.y()));
    if (Math.hypot(nearX - at.x(), nearY - at.y()) > LEADER_FROM + radius) {
      canvas.line(at.x(), at.y(), nearX, nearY, Stroke.solid(Ink.MUTED, 1.0));
    }
    canvas.text(box.x() + 2.0, box.bottom() - 4.0, name, Ink.LABEL);
  }
}
