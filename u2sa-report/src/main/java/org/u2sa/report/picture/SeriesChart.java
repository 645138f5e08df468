package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.u2sa.report.ReportFile;
import org.u2sa.report.page.Trace;

/** Draws quantities over time as a PNG, a chart for each unit, one below the other. */
public final class SeriesChart {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 320;
  private static final double LEFT = 90.0;
  private static final double BOTTOM = 50.0;

  /** Okabe and Ito's, without the yellow. */
  private static final List<Color> COLOURS =
      List.of(
          new Color(0x0072b2),
          new Color(0xd55e00),
          new Color(0x009e73),
          new Color(0xcc79a7),
          new Color(0x56b4e9),
          new Color(0xe69f00));

  private SeriesChart() {}

  /**
   * Writes the picture.
   *
   * @param byUnit the quantities of each unit
   * @param fromS start of the time axis [s]
   * @param toS end of the time axis [s], after its start
   * @throws org.u2sa.interfaces.RunFailedException if it cannot be written
   */
  public static void write(Path file, Map<String, List<Trace>> byUnit, double fromS, double toS) {
    ReportFile.write(
        file,
        out ->
            PictureFile.png(
                out,
                WIDTH,
                HEIGHT * byUnit.size(),
                graphics -> draw(graphics, byUnit, fromS, toS)));
  }

  private static void draw(
      Graphics2D graphics, Map<String, List<Trace>> byUnit, double fromS, double toS) {
    double top = 0.0;
    for (Map.Entry<String, List<Trace>> each : byUnit.entrySet()) {
      chart(each.getKey(), each.getValue(), fromS, toS)
          .draw(graphics, new Rectangle2D.Double(0.0, top, WIDTH, HEIGHT));
      top += HEIGHT;
    }
  }

  private static JFreeChart chart(String unit, List<Trace> traces, double fromS, double toS) {
    NumberAxis times = new NumberAxis("time [s]");
    times.setRange(fromS, toS);
    NumberAxis values = new NumberAxis(unit.isEmpty() ? null : "[" + unit + "]");
    values.setAutoRangeIncludesZero(false);
    XYPlot plot = ChartStyle.plot(times, values, LEFT, BOTTOM);
    XYSeriesCollection lines = new XYSeriesCollection();
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
    renderer.setDrawSeriesLineAsPath(true);
    for (Trace trace : traces) {
      int index = lines.getSeriesCount();
      XYSeries line = new XYSeries(trace.name(), false);
      for (int i = 0; i < trace.size(); i++) {
        line.add(trace.time(i), trace.value(i));
      }
      lines.addSeries(line);
      renderer.setSeriesPaint(index, COLOURS.get(index % COLOURS.size()));
      renderer.setSeriesStroke(index, ChartStyle.stroke(1.6, 0.0));
    }
    ChartStyle.add(plot, lines, renderer);
    JFreeChart chart = ChartStyle.chart(plot, true);
    chart.getLegend().setPosition(RectangleEdge.TOP);
    chart.getLegend().setItemFont(ChartStyle.TICK);
    chart.getLegend().setFrame(BlockBorder.NONE);
    return chart;
  }
}
