package org.u2sa.report.picture;

import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.NumberFormat;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TimeZone;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.DateAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYAreaRenderer;
import org.jfree.chart.renderer.xy.XYStepRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.chart.util.RelativeDateFormat;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.score.WaypointResult;

/**
 * Chart of a quantity over simulated time: planned and true, with the times of closest approach to
 * waypoints.
 */
final class ProfileChart {
  private static final double MS_PER_S = 1000.0;
  private static final double HEADROOM = 0.22; // fraction of the span, for the waypoints' numbers
  private static final double FOOTROOM = 0.08;
  private static final double CLOSE = 0.015; // fraction of the time; closer numbers alternate rows

  private ProfileChart() {}

  /** Creates the chart of a quantity, coloured by another, with a size within its axes [px]. */
  static JFreeChart of(
      RunPlan plan,
      List<TrackSample> track,
      RunScore score,
      Quantity quantity,
      Quantity colour,
      Rectangle2D size) {
    double startMs = track.isEmpty() ? 0.0 : MS_PER_S * track.get(0).timeS();
    double lastMs = track.isEmpty() ? 0.0 : MS_PER_S * track.get(track.size() - 1).timeS();
    DateAxis time =
        new DateAxis("simulated time [min:s]", TimeZone.getTimeZone("UTC"), Locale.ROOT);
    time.setDateFormatOverride(clock());
    double shownMs = (1.0 + CLOSE) * Math.max(MS_PER_S, lastMs - startMs);
    time.setRange(startMs, startMs + shownMs);
    NumberAxis value = new NumberAxis();
    double span = quantity.high() - quantity.low();
    value.setRange(quantity.low() - FOOTROOM * span, quantity.high() + HEADROOM * span);
    value.setNumberFormatOverride(NumberFormat.getInstance(Locale.ROOT));
    XYPlot plot = ChartStyle.plot(time, value, ChartStyle.LEFT, ChartStyle.BELOW);

    XYSeries area = new XYSeries("", false);
    for (TrackSample s : track) {
      area.add(MS_PER_S * s.timeS(), isShown(s, quantity) ? quantity.of().applyAsDouble(s) : 0.0);
    }
    XYAreaRenderer filled = new XYAreaRenderer(XYAreaRenderer.AREA);
    filled.setSeriesPaint(0, ChartStyle.FLOWN_AREA);
    ChartStyle.add(plot, new XYSeriesCollection(area), filled);
    XYStepRenderer steps = new XYStepRenderer();
    steps.setSeriesPaint(0, ChartStyle.MUTED);
    steps.setSeriesStroke(0, ChartStyle.stroke(2.0, 7.0));
    XYSeries planned = planned(plan, track, quantity);
    ChartStyle.add(plot, new XYSeriesCollection(planned), steps);
    ChartStyle.addTrack(
        plot,
        size,
        track,
        colour,
        s -> new Point2D.Double(MS_PER_S * s.timeS(), quantity.of().applyAsDouble(s)));
    ChartStyle.addMarks(
        plot,
        met(score.waypoints(), track, quantity, true),
        List.of(),
        met(score.waypoints(), track, quantity, false));
    moments(plot, score.waypoints());
    boolean isPlanned =
        IntStream.range(0, planned.getItemCount())
            .anyMatch(i -> !Double.isNaN(planned.getY(i).doubleValue()));
    plot.setFixedLegendItems(legend(quantity, isPlanned));
    JFreeChart chart = ChartStyle.chart(plot, true);
    chart.getLegend().setItemFont(ChartStyle.TICK);
    chart.getLegend().setItemPaint(ChartStyle.MUTED);
    chart.getLegend().setFrame(BlockBorder.NONE);
    return chart;
  }

  private static RelativeDateFormat clock() {
    NumberFormat twoDigits = new DecimalFormat("00", DecimalFormatSymbols.getInstance(Locale.ROOT));
    RelativeDateFormat clock = new RelativeDateFormat(0L);
    clock.setShowZeroHours(false);
    clock.setHourSuffix(":");
    clock.setMinuteSuffix(":");
    clock.setSecondSuffix("");
    clock.setSecondFormatter(twoDigits);
    return clock;
  }

  /** Planned value over time; NaN where nothing is planned, or the track has no value. */
  private static XYSeries planned(RunPlan plan, List<TrackSample> track, Quantity quantity) {
    XYSeries planned = new XYSeries("", false);
    for (int i = 0; i < track.size(); i++) {
      int leg = track.get(i).leg();
      boolean isShown = isShown(track.get(i), quantity);
      if (i == 0
          || i == track.size() - 1
          || leg != track.get(i - 1).leg()
          || isShown != isShown(track.get(i - 1), quantity)) {
        OptionalDouble value =
            isShown && leg >= 0 && leg < plan.waypoints().size()
                ? quantity.planned().apply(plan.waypoints().get(leg))
                : OptionalDouble.empty();
        planned.add(MS_PER_S * track.get(i).timeS(), value.orElse(Double.NaN));
      }
    }
    return planned;
  }

  private static boolean isShown(TrackSample sample, Quantity quantity) {
    return !Double.isNaN(quantity.of().applyAsDouble(sample));
  }

  /** Planned values at the closest approach to waypoints on whose legs the track has values. */
  private static List<Point2D> met(
      List<WaypointResult> results, List<TrackSample> track, Quantity quantity, boolean captured) {
    Set<Integer> shown =
        track.stream()
            .filter(sample -> isShown(sample, quantity))
            .map(TrackSample::leg)
            .collect(Collectors.toSet());
    List<Point2D> points = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      WaypointResult result = results.get(i);
      OptionalDouble planned = quantity.planned().apply(result.waypoint());
      if (shown.contains(i)
          && result.captured() == captured
          && result.timeS().isPresent()
          && planned.isPresent()) {
        points.add(
            new Point2D.Double(MS_PER_S * result.timeS().getAsDouble(), planned.getAsDouble()));
      }
    }
    return points;
  }

  /** Hairline at the closest approach to each waypoint, with its number. */
  private static void moments(XYPlot plot, List<WaypointResult> results) {
    double close = CLOSE * plot.getDomainAxis().getRange().getLength();
    double last = Double.NEGATIVE_INFINITY;
    boolean lowered = false;
    for (int i = 0; i < results.size(); i++) {
      if (results.get(i).timeS().isPresent()) {
        double at = MS_PER_S * results.get(i).timeS().getAsDouble();
        lowered = at - last < close && !lowered;
        last = at;
        ValueMarker moment = new ValueMarker(at, ChartStyle.PLANNED, ChartStyle.stroke(1.0, 3.0));
        moment.setLabel(String.valueOf(i + 1));
        moment.setLabelFont(ChartStyle.LABEL);
        moment.setLabelPaint(ChartStyle.TEXT);
        moment.setLabelBackgroundColor(ChartStyle.PANEL);
        moment.setLabelAnchor(RectangleAnchor.TOP);
        moment.setLabelTextAnchor(TextAnchor.TOP_CENTER);
        moment.setLabelOffset(new RectangleInsets(lowered ? 22.0 : 4.0, 0.0, 0.0, 0.0));
        plot.addDomainMarker(moment, Layer.BACKGROUND);
      }
    }
  }

  private static LegendItemCollection legend(Quantity quantity, boolean isPlanned) {
    Shape dash = new Line2D.Double(-17.0, 0.0, 17.0, 0.0);
    LegendItemCollection items = new LegendItemCollection();
    items.add(
        new LegendItem(
            quantity.name() + " [" + quantity.unit() + "]",
            null,
            null,
            null,
            dash,
            ChartStyle.stroke(3.0, 0.0),
            ColourScale.colour(ColourScale.STEPS / 2)));
    if (isPlanned) {
      items.add(
          new LegendItem(
              quantity.plannedName(),
              null,
              null,
              null,
              dash,
              ChartStyle.stroke(2.0, 7.0),
              ChartStyle.MUTED));
    }
    return items;
  }
}
