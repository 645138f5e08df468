package org.u2sa.scenarios.report;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.scenarios.report.Drawing.Anchor;
import org.u2sa.scenarios.report.Drawing.Pen;

/**
 * Draws the map: grid, home, fence, planned line, track, waypoints with their capture circles and
 * names.
 */
final class MapPanel {

  private static final double M_PER_KM = 1000.0;
  private static final double KM_FROM_M = 1000.0; // smaller maps are labelled in metres
  private static final double LINE_WIDTH = 3.4;
  private static final double LEADER_FROM =
      14.0; // a label farther from its waypoint gets a leader line [px]
  private static final double HOME_RADIUS = 7.0; // px
  private static final double LARGEST_WHOLE_CIRCLE = 25.0; // px
  private static final double NAME_HEIGHT = 18.0;
  private static final int MOST_NAMES = 30; // with more waypoints, numbers alone

  private final Drawing drawing;
  private final RunPlan plan;
  private final List<WaypointSign> signs;
  private final MapView view;
  private final TrackLine line;
  private final Quantity colour;
  private final double gridUnitM;

  MapPanel(
      Drawing drawing,
      Rectangle2D.Double frame,
      RunPlan plan,
      List<TrackSample> track,
      RunScore score,
      Quantity colour) {
    this.drawing = drawing;
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
    drawing.draw(view.frame(), Ink.PANEL, null);
    grid();
    drawing.clipped(
        view.frame(),
        () -> {
          captureCircles();
          drawing.polyline(fence(), new Pen(Ink.MISSED, 2.0, 5.0));
          drawing.polyline(planned(), new Pen(Ink.PLANNED, 2.0, 7.0));
          plan.home().ifPresent(this::home);
          line.draw(drawing, LINE_WIDTH);
          signs.forEach(
              sign -> WaypointSign.draw(drawing, view.pixel(sign.waypoint()), sign.captured()));
        });
    drawing.draw(view.frame(), null, Ink.FRAME);
    MapFurniture furniture = new MapFurniture(drawing, view);
    LabelPlacer placer = new LabelPlacer(view.frame());
    furniture.boxes().forEach(placer::avoid);
    names(placer);
    furniture.draw(colour);
  }

  private void grid() {
    Rectangle2D.Double frame = view.frame();
    Ticks ticks = Ticks.between(0.0, Math.max(view.widthM(), view.heightM()) / gridUnitM, 12);
    for (double tick :
        Ticks.every(
                ticks.step(), view.westM() / gridUnitM, (view.westM() + view.widthM()) / gridUnitM)
            .values()) {
      double x = view.x(tick * gridUnitM);
      drawing.line(x, frame.y, x, frame.getMaxY(), Ink.GRID);
      drawing.text(x, frame.getMaxY() + 19.0, ticks.label(tick), Ink.TICK, Anchor.MIDDLE);
    }
    for (double tick :
        Ticks.every(
                ticks.step(),
                view.southM() / gridUnitM,
                (view.southM() + view.heightM()) / gridUnitM)
            .values()) {
      double y = view.y(tick * gridUnitM);
      drawing.line(frame.x, y, frame.getMaxX(), y, Ink.GRID);
      drawing.text(frame.x - 8.0, y + 5.0, ticks.label(tick), Ink.TICK, Anchor.END);
    }
    String origin = plan.home().isPresent() ? "home" : "the first waypoint";
    drawing.text(
        frame.getMaxX(),
        frame.getMaxY() + 40.0,
        (gridUnitM == 1.0 ? "m" : "km") + " east and north of " + origin,
        Ink.TICK,
        Anchor.END);
  }

  /** Once around. */
  private List<Point2D.Double> fence() {
    List<Point2D.Double> line = new ArrayList<>();
    for (RunPlan.Corner corner : plan.fence()) {
      line.add(view.pixel(view.plane().place(corner.longitudeDeg(), corner.latitudeDeg())));
    }
    if (!line.isEmpty()) {
      line.add(line.get(0));
    }
    return line;
  }

  private List<Point2D.Double> planned() {
    List<Point2D.Double> line = new ArrayList<>();
    plan.home()
        .ifPresent(
            home ->
                line.add(view.pixel(view.plane().place(home.longitudeDeg(), home.latitudeDeg()))));
    plan.waypoints().forEach(waypoint -> line.add(view.pixel(waypoint)));
    return line;
  }

  private void home(RunPlan.Start home) {
    Point2D.Double at = view.pixel(view.plane().place(home.longitudeDeg(), home.latitudeDeg()));
    drawing.draw(
        new Rectangle2D.Double(at.x - 6.0, at.y - 6.0, 12.0, 12.0),
        Ink.HOME,
        Pen.solid(Ink.PAPER, 1.5));
  }

  private void captureCircles() {
    for (WaypointSign sign : signs) {
      Point2D.Double at = view.pixel(sign.waypoint());
      double radius = sign.waypoint().captureRadiusM() * view.pixelsPerMetre();
      drawing.circle(
          at.x,
          at.y,
          radius,
          sign.captured() ? Ink.CAPTURED_AREA : Ink.MISSED_AREA,
          Pen.solid(sign.captured() ? Ink.CAPTURED : Ink.MISSED, 1.3));
    }
  }

  private void names(LabelPlacer placer) {
    placer.avoidLine(line.points());
    placer.avoidLine(planned());
    for (WaypointSign sign : signs) {
      Point2D.Double at = view.pixel(sign.waypoint());
      double radius = signRadius(sign);
      placer.avoid(
          new Rectangle2D.Double(at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius));
    }
    boolean crowded = signs.size() > MOST_NAMES;
    for (WaypointSign sign : signs) {
      String name = crowded ? String.valueOf(sign.index() + 1) : sign.numberedName();
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
    return Math.max(WaypointSign.MARK_RADIUS, circle <= LARGEST_WHOLE_CIRCLE ? circle : 0.0) + 1.0;
  }

  private void name(LabelPlacer placer, Point2D.Double at, double radius, String name) {
    double width = Ink.LABEL.widthOf(name) + 4.0;
    Rectangle2D.Double box = placer.place(at.x, at.y, radius, width, NAME_HEIGHT);
    double nearX = Math.max(box.x, Math.min(box.getMaxX(), at.x));
    double nearY = Math.max(box.y, Math.min(box.getMaxY(), at.y));
    if (Math.hypot(nearX - at.x, nearY - at.y) > LEADER_FROM + radius) {
      drawing.line(at.x, at.y, nearX, nearY, Pen.solid(Ink.MUTED, 1.0));
    }
    drawing.text(box.x + 2.0, box.getMaxY() - 4.0, name, Ink.LABEL);
  }
}
