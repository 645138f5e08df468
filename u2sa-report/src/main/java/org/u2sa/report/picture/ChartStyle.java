package org.u2sa.report.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYItemRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.util.ShapeUtils;
import org.jfree.data.xy.XYDataset;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.u2sa.report.score.TrackSample;

/**
 * Common style of a run's charts: colours, fonts, track and waypoint marks. Accents are from Okabe
 * and Ito's palette, distinguishable with colour vision deficiency.
 */
final class ChartStyle {
  static final Color PAPER = Color.WHITE;
  static final Color PANEL = new Color(0xf6f7f9);
  static final Color TEXT = new Color(0x1d2430);
  static final Color MUTED = new Color(0x667080);
  static final Color PLANNED = new Color(0x9aa3b0);
  static final Color CAPTURED = new Color(0x009e73);
  static final Color MISSED = new Color(0xd55e00);
  static final Color HOME = new Color(0x3a4250);
  static final Color FLOWN_AREA = new Color(0x31, 0x68, 0x8e, 0x20);

  static final Font LABEL = font(Font.BOLD, 16);
  static final Font TICK = font(Font.PLAIN, 14);

  /** Half the size of a waypoint's mark [px]. */
  static final double MARK_RADIUS = 5.0;

  /** Room beside and below a plot for its axes [px]. */
  static final double LEFT = 80.0;

  static final double BELOW = 50.0;
  static final double RIGHT = 20.0;

  /** For the sizes of texts. */
  static final FontRenderContext FONTS = new FontRenderContext(null, true, true);

  private static final Color FAINT = new Color(0xdfe3e9);

  private ChartStyle() {}

  /**
   * A translucent colour.
   *
   * @param alpha 0…255
   */
  static Color withAlpha(Color colour, int alpha) {
    return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
  }

  static Font font(int style, int size) {
    String family =
        List.of("Liberation Sans", "Arial", "Helvetica", "DejaVu Sans").stream()
            .filter(name -> new Font(name, style, 1).getFamily().equals(name)) // else Java's Dialog
            .findFirst()
            .orElse(Font.SANS_SERIF);
    return new Font(family, style, size);
  }

  /** A text, cut if it is wider than a width [px]. */
  static String fitted(String text, Font font, double width) {
    String cut = text;
    while (cut.length() > 1 && font.getStringBounds(cut + "\u2026", FONTS).getWidth() > width) {
      cut = cut.substring(0, cut.length() - 1);
    }
    return cut.length() == text.length() ? text : cut + "\u2026";
  }

  /** Formats minutes and seconds. */
  static String clock(double seconds) {
    long whole = Math.round(seconds);
    return String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60);
  }

  /** Stroke with a width [px], dashed if {@code dash} [px] is more than 0. */
  static BasicStroke stroke(double width, double dash) {
    float[] dashes = dash > 0.0 ? new float[] {(float) dash} : null;
    return new BasicStroke(
        (float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1.0f, dashes, 0.0f);
  }

  /** Creates an empty plot, later datasets on top, with room for the labels of its axes [px]. */
  static XYPlot plot(ValueAxis domain, ValueAxis range, double left, double bottom) {
    XYPlot plot = new XYPlot(null, domain, range, null);
    for (ValueAxis axis : List.of(domain, range)) {
      axis.setTickLabelFont(TICK);
      axis.setTickLabelPaint(MUTED);
      axis.setLabelFont(TICK);
      axis.setLabelPaint(MUTED);
      axis.setAxisLineVisible(false);
    }
    AxisSpace below = new AxisSpace();
    below.setBottom(bottom);
    plot.setFixedDomainAxisSpace(below);
    AxisSpace beside = new AxisSpace();
    beside.setLeft(left);
    beside.setRight(RIGHT);
    plot.setFixedRangeAxisSpace(beside);
    plot.setInsets(RectangleInsets.ZERO_INSETS);
    plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
    plot.setBackgroundPaint(PANEL);
    plot.setOutlinePaint(PLANNED);
    plot.setDomainGridlinePaint(FAINT);
    plot.setRangeGridlinePaint(FAINT);
    plot.setDomainGridlineStroke(stroke(1.0, 0.0));
    plot.setRangeGridlineStroke(stroke(1.0, 0.0));
    plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
    return plot;
  }

  /** Chart of the plot, without a frame. */
  static JFreeChart chart(XYPlot plot, boolean legend) {
    JFreeChart chart = new JFreeChart(null, TICK, plot, legend);
    chart.setBackgroundPaint(PAPER);
    chart.setPadding(RectangleInsets.ZERO_INSETS);
    return chart;
  }

  /** Adds a dataset on top of all others. */
  static void add(XYPlot plot, XYDataset data, XYItemRenderer renderer) {
    int index =
        plot.getDatasetCount() == 1 && plot.getDataset() == null ? 0 : plot.getDatasetCount();
    plot.setDataset(index, data);
    plot.setRenderer(index, renderer);
  }

  /** Adds a dashed line through points, in their order. */
  static void addLine(XYPlot plot, List<Point2D> points, Color colour, double dash) {
    XYSeries line = new XYSeries("", false);
    points.forEach(p -> line.add(p.getX(), p.getY()));
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
    renderer.setDrawSeriesLineAsPath(true);
    renderer.setSeriesPaint(0, colour);
    renderer.setSeriesStroke(0, stroke(2.0, dash));
    add(plot, new XYSeriesCollection(line), renderer);
  }

  /**
   * Adds the track as a line coloured by a quantity, omitting points less than a pixel apart. The
   * line is interrupted where a sample has no place.
   *
   * @param size size of the plot [px]
   * @param place plot coordinates of a sample; NaN if it has none
   */
  static void addTrack(
      XYPlot plot,
      Rectangle2D size,
      List<TrackSample> track,
      Quantity quantity,
      Function<TrackSample, Point2D> place) {
    double pixelX = plot.getDomainAxis().getRange().getLength() / size.getWidth();
    double pixelY = plot.getRangeAxis().getRange().getLength() / size.getHeight();
    XYSeriesCollection lines = new XYSeriesCollection();
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
    renderer.setDrawSeriesLineAsPath(true);
    renderer.setAutoPopulateSeriesStroke(false);
    renderer.setDefaultStroke(stroke(3.2, 0.0));
    XYSeries line = null;
    int shown = -1;
    Point2D last = null;
    for (int i = 0; i < track.size(); i++) {
      Point2D at = place.apply(track.get(i));
      if (Double.isNaN(at.getX()) || Double.isNaN(at.getY())) {
        line = null;
        shown = -1;
        last = null;
        continue;
      }
      if (last != null
          && i < track.size() - 1
          && Math.hypot((at.getX() - last.getX()) / pixelX, (at.getY() - last.getY()) / pixelY)
              < 1.0) {
        continue;
      }
      last = at;
      if (line != null) {
        line.add(at.getX(), at.getY()); // the next colour starts where this one ends
      }
      double value = quantity.of().applyAsDouble(track.get(i));
      int step = ColourScale.step(value, quantity.low(), quantity.high());
      if (step != shown) {
        shown = step;
        renderer.setSeriesPaint(lines.getSeriesCount(), ColourScale.colour(step));
        line = new XYSeries(lines.getSeriesCount(), false);
        line.add(at.getX(), at.getY());
        lines.addSeries(line);
      }
    }
    add(plot, lines, renderer);
  }

  /** Adds small dots. */
  static void addSpots(XYPlot plot, List<Point2D> places, Color colour) {
    XYSeriesCollection spots = new XYSeriesCollection();
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
    addMarks(spots, renderer, places, colour, new Ellipse2D.Double(-3.5, -3.5, 7.0, 7.0));
    add(plot, spots, renderer);
  }

  /** Marks waypoints: dot: captured; ring: sometimes; cross: missed. */
  static void addMarks(
      XYPlot plot, List<Point2D> captured, List<Point2D> sometimes, List<Point2D> missed) {
    XYSeriesCollection marks = new XYSeriesCollection();
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
    Ellipse2D dot =
        new Ellipse2D.Double(-MARK_RADIUS, -MARK_RADIUS, 2.0 * MARK_RADIUS, 2.0 * MARK_RADIUS);
    addMarks(marks, renderer, captured, CAPTURED, dot);
    addMarks(marks, renderer, sometimes, CAPTURED, ring(dot));
    addMarks(
        marks, renderer, missed, MISSED, ShapeUtils.createDiagonalCross((float) MARK_RADIUS, 1.2f));
    renderer.setUseOutlinePaint(true);
    renderer.setDefaultOutlinePaint(PAPER);
    renderer.setAutoPopulateSeriesOutlinePaint(false);
    add(plot, marks, renderer);
  }

  private static void addMarks(
      XYSeriesCollection marks,
      XYLineAndShapeRenderer renderer,
      List<Point2D> places,
      Color colour,
      Shape shape) {
    int index = marks.getSeriesCount();
    XYSeries series = new XYSeries(index, false);
    places.forEach(p -> series.add(p.getX(), p.getY()));
    marks.addSeries(series);
    renderer.setSeriesPaint(index, colour);
    renderer.setSeriesShape(index, shape);
  }

  private static Shape ring(Ellipse2D dot) {
    Area ring = new Area(dot);
    double inside = 0.55 * MARK_RADIUS;
    ring.subtract(new Area(new Ellipse2D.Double(-inside, -inside, 2.0 * inside, 2.0 * inside)));
    return ring;
  }
}
