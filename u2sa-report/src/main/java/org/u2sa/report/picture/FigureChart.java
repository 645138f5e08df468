package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.io.StringWriter;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.CategoryAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.category.BoxAndWhiskerRenderer;
import org.jfree.chart.renderer.xy.StandardXYBarPainter;
import org.jfree.chart.renderer.xy.XYBarRenderer;
import org.jfree.data.statistics.DefaultBoxAndWhiskerCategoryDataset;
import org.jfree.data.statistics.HistogramDataset;

/** Draws the distribution of a metric over many runs, as SVG. */
public final class FigureChart {
  private static final int WIDTH = 520;
  private static final int HEIGHT = 300;
  private static final double LEFT = 60.0;
  private static final double BOTTOM = 50.0;
  private static final int MAX_BINS = 40;
  private static final Color BAR = new Color(0x31688e);
  private static final Color BOX = new Color(0xa9c4d8);

  private FigureChart() {}

  /**
   * Draws a histogram.
   *
   * @param name name of the metric
   * @param values one per run, not all equal
   */
  public static String histogram(String name, double[] values) {
    HistogramDataset data = new HistogramDataset();
    int bins = Math.max(5, Math.min(MAX_BINS, (int) Math.ceil(2.0 * Math.cbrt(values.length))));
    data.addSeries(name, values, bins); // Rice's rule
    NumberAxis runs = new NumberAxis("runs");
    runs.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    NumberAxis figure = new NumberAxis(name);
    figure.setAutoRangeIncludesZero(false);
    XYPlot plot = ChartStyle.plot(figure, runs, LEFT, BOTTOM);
    XYBarRenderer bars = new XYBarRenderer(0.05);
    bars.setBarPainter(new StandardXYBarPainter());
    bars.setShadowVisible(false);
    bars.setSeriesPaint(0, BAR);
    ChartStyle.add(plot, data, bars);
    return svg(name, ChartStyle.chart(plot, false));
  }

  /**
   * Draws a box plot of a metric over a parameter: for each parameter value, quartiles, median and
   * extremes.
   *
   * @param name name of the metric
   * @param parameter swept parameter
   * @param byValue the runs' metrics for each parameter value, in drawing order
   */
  public static String dependence(String name, String parameter, Map<String, double[]> byValue) {
    DefaultBoxAndWhiskerCategoryDataset data = new DefaultBoxAndWhiskerCategoryDataset();
    byValue.forEach(
        (value, figures) -> {
          List<Double> all = Arrays.stream(figures).boxed().toList();
          data.add(all, name, value);
        });
    BoxAndWhiskerRenderer boxes = new BoxAndWhiskerRenderer();
    boxes.setSeriesPaint(0, BOX);
    boxes.setMaximumBarWidth(0.15);
    boxes.setUseOutlinePaintForWhiskers(true);
    boxes.setMeanVisible(false);
    NumberAxis figure = new NumberAxis(name);
    figure.setAutoRangeIncludesZero(false);
    CategoryAxis values = new CategoryAxis(parameter);
    CategoryPlot plot = new CategoryPlot(data, values, figure, boxes);
    plot.setBackgroundPaint(ChartStyle.PANEL);
    plot.setOutlinePaint(ChartStyle.PLANNED);
    values.setTickLabelFont(ChartStyle.TICK);
    values.setLabelFont(ChartStyle.TICK);
    figure.setTickLabelFont(ChartStyle.TICK);
    figure.setLabelFont(ChartStyle.TICK);
    JFreeChart chart = new JFreeChart(null, ChartStyle.TICK, plot, false);
    chart.setBackgroundPaint(ChartStyle.PAPER);
    return svg(name + " by " + parameter, chart);
  }

  private static String svg(String title, JFreeChart chart) {
    Consumer<Graphics2D> content =
        graphics -> chart.draw(graphics, new Rectangle2D.Double(0.0, 0.0, WIDTH, HEIGHT));
    StringWriter text = new StringWriter();
    PictureFile.svg(text, title, WIDTH, HEIGHT, content);
    return text.toString();
  }
}
