package org.u2sa.gcs.services;

import java.awt.Color;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Canvas.Pixel;
import org.u2sa.gcs.draw.PixelBox;
import org.u2sa.gcs.draw.Stroke;
import org.u2sa.gcs.draw.SvgCanvas;
import org.u2sa.gcs.draw.TextStyle;

/**
 * Draws who feeds whom: services side by side, from those that measure to those that move, and
 * below them a lane for each channel, with a dot at who publishes and an arrow head at who is fed.
 */
final class GraphPicture {
  private static final Color PAPER = Color.WHITE;
  private static final Color INK = new Color(0x22, 0x2b, 0x38);
  private static final Color FAINT = new Color(0xc9, 0xd1, 0xdb);
  private static final Color BOX = new Color(0xe8, 0xf0, 0xfa);
  private static final Color SOFT = new Color(0x5b, 0x68, 0x79);
  private static final Color LOOSE = new Color(0xc2, 0x41, 0x0c);
  private static final List<Color> LANES =
      List.of(
          new Color(0x1d, 0x5f, 0xa8), new Color(0x0f, 0x76, 0x6e), new Color(0x7c, 0x3a, 0xad));

  private static final TextStyle TITLE = TextStyle.of(INK, 20.0).inBold();
  private static final TextStyle NAME =
      TextStyle.of(INK, 14.0).inBold().anchored(TextStyle.Anchor.MIDDLE);
  private static final TextStyle ROLE = TextStyle.of(SOFT, 11.0).anchored(TextStyle.Anchor.MIDDLE);
  private static final TextStyle LABEL = TextStyle.of(INK, 12.0);
  private static final TextStyle NOTE = TextStyle.of(SOFT, 12.0);

  private static final double MARGIN = 28.0;
  private static final double BOX_TOP = 62.0;
  private static final double BOX_HEIGHT = 46.0;
  private static final double BOX_GAP = 22.0;
  private static final double FIRST_LANE = BOX_TOP + BOX_HEIGHT + 44.0;
  private static final double LANE_HEIGHT = 40.0;
  private static final double FOOT = 46.0;
  private static final double STUB = 44.0;
  private static final double DOT = 4.5;
  private static final double HEAD = 9.0;

  private final ServiceGraph graph;
  private final List<String> channels;
  private final double columnWidth;

  private GraphPicture(ServiceGraph graph) {
    this.graph = graph;
    channels = graph.channels();
    double widest = 130.0;
    for (String service : graph.services()) {
      widest = Math.max(widest, NAME.widthOf(service) + 24.0);
      widest = Math.max(widest, ROLE.widthOf(graph.roles().get(service)) + 24.0);
    }
    for (String channel : channels) {
      widest = Math.max(widest, LABEL.widthOf(label(channel)) + 2.0 * HEAD - BOX_GAP);
    }
    columnWidth = widest + BOX_GAP;
  }

  /** The SVG file of the graph. */
  static String svg(String systemId, ServiceGraph graph) {
    GraphPicture picture = new GraphPicture(graph);
    double width = 2.0 * MARGIN + graph.services().size() * picture.columnWidth + STUB;
    double height = FIRST_LANE + picture.channels.size() * LANE_HEIGHT + FOOT;
    String title = "Who feeds whom in system " + systemId;
    SvgCanvas canvas = new SvgCanvas((int) Math.ceil(width), (int) Math.ceil(height), title);
    canvas.rectangle(new PixelBox(0.0, 0.0, width, height), PAPER, null);
    canvas.text(MARGIN, 36.0, title, TITLE);
    picture.services(canvas, height - FOOT);
    for (int i = 0; i < picture.channels.size(); i++) {
      picture.lane(canvas, picture.channels.get(i), FIRST_LANE + i * LANE_HEIGHT, i);
    }
    picture.legend(canvas, height - 16.0);
    return canvas.document();
  }

  private double x(String service) {
    return MARGIN + (graph.services().indexOf(service) + 0.5) * columnWidth;
  }

  private void services(Canvas canvas, double bottom) {
    for (String service : graph.services()) {
      double x = x(service);
      double width = columnWidth - BOX_GAP;
      canvas.line(x, BOX_TOP + BOX_HEIGHT, x, bottom, Stroke.solid(FAINT, 1.5));
      canvas.rectangle(
          new PixelBox(x - width / 2.0, BOX_TOP, width, BOX_HEIGHT), BOX, Stroke.solid(INK, 1.2));
      canvas.text(x, BOX_TOP + 20.0, service, NAME);
      canvas.text(x, BOX_TOP + 37.0, graph.roles().get(service), ROLE);
    }
  }

  private String label(String channel) {
    Set<String> types = new TreeSet<>();
    for (Feed feed : graph.feeds()) {
      if (feed.channel().equals(channel)) {
        types.add(feed.type());
      }
    }
    for (List<Loose> ends : List.of(graph.unheard(), graph.unfed())) {
      for (Loose end : ends) {
        if (types.isEmpty() && end.channel().equals(channel)) {
          types.add(end.type());
        }
      }
    }
    return channel + ": " + String.join(", ", types);
  }

  private void lane(Canvas canvas, String channel, double y, int index) {
    Set<Double> from = new TreeSet<>();
    Set<Double> to = new TreeSet<>();
    for (Feed feed : graph.feeds()) {
      if (feed.channel().equals(channel)) {
        from.add(x(feed.from()));
        to.add(x(feed.to()));
      }
    }
    Color color = LANES.get(index % LANES.size());
    double left = Double.POSITIVE_INFINITY;
    if (!from.isEmpty()) {
      Set<Double> all = new TreeSet<>(from);
      all.addAll(to);
      left = all.stream().mapToDouble(x -> x).min().orElseThrow();
      double right = all.stream().mapToDouble(x -> x).max().orElseThrow();
      canvas.line(left, y, right, y, Stroke.solid(color, 2.0));
      to.forEach(x -> heads(canvas, x, y, from, color));
      from.forEach(x -> canvas.circle(x, y, DOT, color, Stroke.solid(PAPER, 1.5)));
    }
    left = Math.min(left, stubs(canvas, channel, y));
    canvas.textOnHalo(left + 2.0 * HEAD, y - 7.0, label(channel), LABEL, PAPER);
  }

  /** An arrow head at x from each side on which somebody publishes. */
  private static void heads(Canvas canvas, double x, double y, Set<Double> from, Color color) {
    if (from.stream().anyMatch(source -> source < x)) {
      head(canvas, x, y, -HEAD, color);
    }
    if (from.stream().anyMatch(source -> source > x)) {
      head(canvas, x, y, HEAD, color);
    }
  }

  private static void head(Canvas canvas, double tip, double y, double back, Color color) {
    canvas.polygon(
        List.of(
            new Pixel(tip, y),
            new Pixel(tip + back, y - HEAD / 2.0),
            new Pixel(tip + back, y + HEAD / 2.0)),
        color);
  }

  /** Draws the ends that hang loose; returns where the leftmost service stands. */
  private double stubs(Canvas canvas, String channel, double y) {
    double left = Double.POSITIVE_INFINITY;
    Stroke dashed = Stroke.dashed(LOOSE, 1.8, 4.0);
    for (Loose end : graph.unheard()) {
      if (end.channel().equals(channel)) {
        double x = x(end.service());
        canvas.line(x, y, x + STUB, y, dashed);
        canvas.circle(x, y, DOT, LOOSE, Stroke.solid(PAPER, 1.5));
        left = Math.min(left, x);
      }
    }
    for (Loose end : graph.unfed()) {
      if (end.channel().equals(channel)) {
        double x = x(end.service());
        canvas.line(x - STUB, y, x - HEAD, y, dashed);
        head(canvas, x, y, -HEAD, LOOSE);
        left = Math.min(left, x);
      }
    }
    return left;
  }

  private void legend(Canvas canvas, double y) {
    String text = "dot: publishes \u00b7 arrow head: is fed \u00b7 dashed: nobody at the other end";
    canvas.text(MARGIN, y, text, NOTE);
  }
}
