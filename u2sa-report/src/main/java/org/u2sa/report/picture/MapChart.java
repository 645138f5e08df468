package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.text.NumberFormat;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.annotations.XYShapeAnnotation;
import org.jfree.chart.annotations.XYTitleAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.PaintScaleLegend;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.PlotPlane;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.TrackSample;

/**
 * North-up map of a run with equal axis scales and its origin at home (or the first waypoint or
 * sample): fence, planned line, track, and waypoints with capture circles and names.
 */
final class MapChart {
  private static final double M_PER_KM = 1000.0; // smaller maps use metres
  private static final int MAX_GRID_LINES = 12;
  private static final int MAX_NAMES = 30; // with more waypoints, only numbers
  private static final double KEY_SHARE = 0.16; // of the map's width, for the colour key
  private static final int KEY_NUMBERS = 5;
  private static final double KEY_HEIGHT = 64.0; // px

  private final RunPlan plan;
  private final List<TrackSample> track;
  private final Quantity colour;
  private final Rectangle2D size;
  private final ObstacleLayer obstacles;
  private final List<WaypointSign> signs;
  private final PlotPlane plane;
  private final double unitM;
  private final XYPlot plot;

  private MapChart(
      RunPlan plan, List<TrackSample> track, RunScore score, Quantity colour, Rectangle2D size) {
    this.plan = plan;
    this.track = track;
    this.colour = colour;
    this.size = size;
    obstacles = new ObstacleLayer(plan, score.obstacles(), track, this::at);
    signs = WaypointSign.of(score.waypoints());
    plane = plane();
    MapExtent around = MapExtent.of(plan, track, obstacles.outlines(), plane, size);
    Rectangle2D extent = around.box();
    double metresPerPixel = around.metresPerPixel();
    double widthM = metresPerPixel * size.getWidth();
    double heightM = metresPerPixel * size.getHeight();
    unitM = plan.domain() != Domain.AIR && widthM < M_PER_KM ? 1.0 : M_PER_KM;
    NumberAxis east =
        new NumberAxis(
            (unitM == 1.0 ? "m" : "km")
                + " east and north of "
                + (plan.home().isPresent() ? "home" : "the first waypoint"));
    NumberAxis north = new NumberAxis();
    NumberTickUnit grid = roundStep(widthM / unitM / MAX_GRID_LINES);
    range(east, grid, extent.getCenterX(), widthM);
    range(north, grid, extent.getCenterY(), heightM);
    plot = ChartStyle.plot(east, north, ChartStyle.LEFT, ChartStyle.BELOW);
  }

  /** Smallest of 1, 2 or 5 times a power of ten that is at least {@code least}. */
  private static NumberTickUnit roundStep(double least) {
    return (NumberTickUnit)
        new NumberTickUnitSource(false, NumberFormat.getInstance(Locale.ROOT))
            .getCeilingTickUnit(least);
  }

  private void range(NumberAxis axis, NumberTickUnit grid, double centreM, double extentM) {
    axis.setRange((centreM - extentM / 2.0) / unitM, (centreM + extentM / 2.0) / unitM);
    axis.setTickUnit(grid);
  }

  /** Creates the map of a run, with a size within its axes [px]. */
  static JFreeChart of(
      RunPlan plan, List<TrackSample> track, RunScore score, Quantity colour, Rectangle2D size) {
    return new MapChart(plan, track, score, colour, size).chart();
  }

  private JFreeChart chart() {
    List<List<Point2D>> planned = planned();
    obstacles.addTo(plot);
    ChartStyle.addLine(plot, outline(plan.fence()), ChartStyle.MISSED, 5.0);
    plan.keepOuts()
        .forEach(area -> ChartStyle.addLine(plot, outline(area), ChartStyle.MISSED, 5.0));
    planned.forEach(line -> ChartStyle.addLine(plot, line, ChartStyle.PLANNED, 7.0));
    ChartStyle.addTrack(
        plot, size, track, colour, sample -> at(sample.longitudeDeg(), sample.latitudeDeg()));
    ChartStyle.addMarks(
        plot,
        at(WaypointSign::captured),
        at(sign -> !sign.captured() && !sign.missed()),
        at(WaypointSign::missed));
    ChartStyle.addSpots(plot, obstacles.moments(), ObstacleLayer.WAY);
    signs.forEach(this::captureCircle);
    plot.addAnnotation(new Names(planned));
    plot.addAnnotation(key());
    return ChartStyle.chart(plot, false);
  }

  /** The planned lines, interrupted by goals without a known position. */
  private List<List<Point2D>> planned() {
    List<List<Point2D>> lines = new ArrayList<>();
    List<Point2D> line = new ArrayList<>();
    plan.home().map(home -> at(home.longitudeDeg(), home.latitudeDeg())).ifPresent(line::add);
    for (int i = 0; i < plan.waypoints().size(); i++) {
      int index = i;
      if (plan.others().stream().anyMatch(other -> other.before() == index)) {
        lines.add(line);
        line = new ArrayList<>();
      }
      line.add(at(plan.waypoints().get(i)));
    }
    lines.add(line);
    return lines;
  }

  private List<Point2D> outline(List<RunPlan.Corner> corners) {
    List<Point2D> line = new ArrayList<>();
    corners.forEach(corner -> line.add(at(corner.longitudeDeg(), corner.latitudeDeg())));
    line.stream().findFirst().ifPresent(line::add); // closes the polygon
    return line;
  }

  private void captureCircle(WaypointSign sign) {
    Color edge = sign.missed() ? ChartStyle.MISSED : ChartStyle.CAPTURED;
    double radius = sign.waypoint().captureRadiusM() / unitM;
    Point2D at = at(sign.waypoint());
    ((XYLineAndShapeRenderer) plot.getRenderer())
        .addAnnotation(
            new XYShapeAnnotation(
                new Ellipse2D.Double(
                    at.getX() - radius, at.getY() - radius, 2.0 * radius, 2.0 * radius),
                ChartStyle.stroke(1.3, 0.0),
                edge,
                ChartStyle.withAlpha(edge, 0x24)),
            Layer.BACKGROUND);
  }

  /** Colour key in the lower right corner. */
  private XYTitleAnnotation key() {
    NumberAxis axis = new NumberAxis(colour.name() + " [" + colour.unit() + "]");
    axis.setTickUnit(roundStep((colour.high() - colour.low()) / KEY_NUMBERS));
    axis.setTickLabelFont(ChartStyle.TICK);
    axis.setLabelFont(ChartStyle.TICK);
    PaintScaleLegend legend =
        new PaintScaleLegend(new ColourScale(colour.low(), colour.high()), axis);
    legend.setPosition(RectangleEdge.BOTTOM);
    legend.setSubdivisionCount(ColourScale.STEPS);
    legend.setStripOutlineVisible(false);
    legend.setStripWidth(12.0);
    legend.setPadding(new RectangleInsets(6.0, 14.0, 2.0, 14.0));
    legend.setBackgroundPaint(ChartStyle.PANEL);
    XYTitleAnnotation key = new XYTitleAnnotation(0.99, 0.02, legend, RectangleAnchor.BOTTOM_RIGHT);
    key.setMaxWidth(KEY_SHARE);
    return key;
  }

  private PlotPlane plane() {
    if (plan.home().isPresent()) {
      return new PlotPlane(plan.home().get().longitudeDeg(), plan.home().get().latitudeDeg());
    }
    if (!plan.waypoints().isEmpty()) {
      return new PlotPlane(plan.waypoints().get(0));
    }
    return track.isEmpty()
        ? new PlotPlane(0.0, 0.0)
        : new PlotPlane(track.get(0).longitudeDeg(), track.get(0).latitudeDeg());
  }

  private List<Point2D> at(Predicate<WaypointSign> condition) {
    return signs.stream().filter(condition).map(sign -> at(sign.waypoint())).toList();
  }

  private Point2D at(double longitudeDeg, double latitudeDeg) {
    PlotPlane.Place place = plane.place(longitudeDeg, latitudeDeg);
    return new Point2D.Double(place.eastM() / unitM, place.northM() / unitM);
  }

  private Point2D at(RunPlan.Waypoint waypoint) {
    return at(waypoint.longitudeDeg(), waypoint.latitudeDeg());
  }

  /** Names of home and the waypoints, placed with least overlap. */
  private final class Names extends AbstractXYAnnotation {
    private static final long serialVersionUID = 1L;
    private static final Font OBSTACLE = ChartStyle.font(Font.ITALIC, 14);
    private static final double HEIGHT = 18.0; // px
    private static final double HOME_RADIUS = 7.0; // px
    private static final double LEADER_FROM = 14.0; // farther names get a line to the point [px]
    private static final double LARGEST_WHOLE_CIRCLE = 25.0; // px
    private static final double LARGEST_AVOIDED = 60.0; // names are inside larger objects [px]

    private final transient List<List<Point2D>> planned;

    Names(List<List<Point2D>> planned) {
      this.planned = planned;
    }

    @Override
    public void draw(
        Graphics2D graphics,
        XYPlot map,
        Rectangle2D area,
        ValueAxis east,
        ValueAxis north,
        int rendererIndex,
        PlotRenderingInfo info) {
      LabelPlacer placer = new LabelPlacer(area);
      placer.avoid(
          new Rectangle2D.Double(
              area.getMaxX() - KEY_SHARE * area.getWidth() - 20.0,
              area.getMaxY() - KEY_HEIGHT - 20.0,
              KEY_SHARE * area.getWidth() + 20.0,
              KEY_HEIGHT + 20.0));
      placer.avoidLine(
          track.stream().map(s -> pixel(at(s.longitudeDeg(), s.latitudeDeg()), area)).toList());
      for (List<Point2D> line : planned) {
        placer.avoidLine(line.stream().map(p -> pixel(p, area)).toList());
      }
      for (List<Point2D> line : obstacles.ways()) {
        placer.avoidLine(line.stream().map(p -> pixel(p, area)).toList());
      }
      List<List<Point2D>> fences = new ArrayList<>();
      fences.add(outline(plan.fence()));
      plan.keepOuts().forEach(keepOut -> fences.add(outline(keepOut)));
      for (List<Point2D> fence : fences) {
        placer.avoidLine(fence.stream().map(p -> pixel(p, area)).toList());
      }
      for (ObstacleLayer.Name each : obstacles.names()) {
        Rectangle2D shape = shape(each, area);
        if (Math.max(shape.getWidth(), shape.getHeight()) <= LARGEST_AVOIDED) {
          placer.avoid(
              new Rectangle2D.Double(
                  shape.getX(), shape.getY(), shape.getWidth(), shape.getHeight()));
        }
      }
      for (WaypointSign sign : signs) {
        Point2D at = pixel(at(sign.waypoint()), area);
        double radius = radius(sign);
        placer.avoid(
            new Rectangle2D.Double(
                at.getX() - radius, at.getY() - radius, 2.0 * radius, 2.0 * radius));
      }
      for (WaypointSign sign : signs) {
        boolean crowded = signs.size() > MAX_NAMES;
        String name = crowded ? String.valueOf(sign.index() + 1) : sign.numberedName();
        String text = name + sign.share();
        name(graphics, placer, pixel(at(sign.waypoint()), area), radius(sign), text);
      }
      for (ObstacleLayer.Name each : obstacles.names()) {
        Point2D at = pixel(each.at(), area);
        if (area.contains(at)) {
          Rectangle2D shape = shape(each, area);
          double half = 0.5 * Math.max(shape.getWidth(), shape.getHeight());
          double radius = half <= 0.5 * LARGEST_AVOIDED ? half : 0.0;
          name(
              graphics,
              placer,
              at,
              Math.max(ChartStyle.MARK_RADIUS, radius),
              each.text(),
              OBSTACLE,
              each.colour());
        }
      }
      for (int i = 0; i < fences.size(); i++) {
        String text = i == 0 ? "fence" : "keep-out";
        List<Point2D> fence = fences.get(i).stream().map(p -> pixel(p, area)).toList();
        LabelPlacer.visibleMiddle(fence, area)
            .ifPresent(at -> name(graphics, placer, at, 0.0, text, OBSTACLE, ChartStyle.MISSED));
      }
      plan.home()
          .map(home -> pixel(at(home.longitudeDeg(), home.latitudeDeg()), area))
          .ifPresent(
              at -> {
                graphics.setPaint(ChartStyle.HOME);
                graphics.fill(new Rectangle2D.Double(at.getX() - 6.0, at.getY() - 6.0, 12.0, 12.0));
                name(graphics, placer, at, HOME_RADIUS, "home");
              });
      others(graphics, area);
    }

    /** Goals that are not on the map, in its lower left corner. */
    private void others(Graphics2D graphics, Rectangle2D area) {
      if (!plan.others().isEmpty()) {
        String text =
            plan.others().stream()
                .map(RunPlan.OtherGoal::name)
                .collect(Collectors.joining(", ", "goals without a known position: ", ""));
        graphics.setPaint(ChartStyle.MUTED);
        graphics.setFont(ChartStyle.TICK);
        double width = (1.0 - KEY_SHARE) * area.getWidth() - 40.0;
        graphics.drawString(
            ChartStyle.fitted(text, ChartStyle.TICK, width),
            (float) area.getX() + 10.0f,
            (float) area.getMaxY() - 10.0f);
      }
    }

    /** Bounding box of an object [px]. */
    private Rectangle2D shape(ObstacleLayer.Name name, Rectangle2D area) {
      return name.outline().stream()
          .map(corner -> pixel(corner, area))
          .map(corner -> (Rectangle2D) new Rectangle2D.Double(corner.getX(), corner.getY(), 0, 0))
          .reduce(Rectangle2D::createUnion)
          .orElse(new Rectangle2D.Double());
    }

    private Point2D pixel(Point2D place, Rectangle2D area) {
      return new Point2D.Double(
          plot.getDomainAxis().valueToJava2D(place.getX(), area, RectangleEdge.BOTTOM),
          plot.getRangeAxis().valueToJava2D(place.getY(), area, RectangleEdge.LEFT));
    }

    /** Radius that names avoid: the whole capture circle if small, otherwise the mark only. */
    private double radius(WaypointSign sign) {
      double circle =
          sign.waypoint().captureRadiusM()
              / unitM
              / plot.getDomainAxis().getRange().getLength()
              * size.getWidth();
      return Math.max(ChartStyle.MARK_RADIUS, circle <= LARGEST_WHOLE_CIRCLE ? circle : 0.0) + 1.0;
    }

    private void name(
        Graphics2D graphics, LabelPlacer placer, Point2D at, double radius, String name) {
      name(graphics, placer, at, radius, name, ChartStyle.LABEL, ChartStyle.TEXT);
    }

    private void name(
        Graphics2D graphics,
        LabelPlacer placer,
        Point2D at,
        double radius,
        String name,
        Font font,
        Color colour) {
      double width = font.getStringBounds(name, ChartStyle.FONTS).getWidth() + 4.0;
      Rectangle2D box = placer.place(at.getX(), at.getY(), radius, width, HEIGHT);
      double nearX = Math.max(box.getMinX(), Math.min(box.getMaxX(), at.getX()));
      double nearY = Math.max(box.getMinY(), Math.min(box.getMaxY(), at.getY()));
      if (at.distance(nearX, nearY) > LEADER_FROM + radius) {
        graphics.setPaint(ChartStyle.MUTED);
        graphics.setStroke(ChartStyle.stroke(1.0, 0.0));
        graphics.draw(new Line2D.Double(at, new Point2D.Double(nearX, nearY)));
      }
      graphics.setPaint(colour);
      graphics.setFont(font);
      graphics.drawString(name, (float) (box.getX() + 2.0), (float) (box.getMaxY() - 4.0));
    }
  }
}
