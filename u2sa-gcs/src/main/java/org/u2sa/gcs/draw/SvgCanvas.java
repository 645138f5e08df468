package org.u2sa.gcs.draw;

import java.awt.Color;
import java.util.List;
import java.util.Locale;

/**
 * Draws into the text of an SVG 1.1 file: the same calls give the same bytes, and no font or
 * library is needed.
 */
public final class SvgCanvas implements Canvas {

  private static final String FONTS =
      "'Liberation Sans', Arial, Helvetica, 'DejaVu Sans', sans-serif";
  private static final int OPAQUE = 255;

  private final StringBuilder svg = new StringBuilder();
  private int clips;

  /**
   * @param title what viewers and screen readers call the picture
   */
  public SvgCanvas(int width, int height, String title) {
    svg.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    svg.append(
        format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\"",
            width, height, width, height));
    svg.append(
        " font-family=\""
            + FONTS
            + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\" fill=\"none\">\n");
    svg.append("<title>").append(SvgEscapes.escaped(title)).append("</title>\n");
  }

  /** The whole file. */
  public String document() {
    return svg + "</svg>\n";
  }

  @Override
  public void polyline(List<Pixel> points, Stroke stroke) {
    if (points.size() >= 2) {
      svg.append("<polyline points=\"")
          .append(coordinates(points))
          .append('"')
          .append(attributes(null, stroke))
          .append("/>\n");
    }
  }

  @Override
  public void polygon(List<Pixel> points, Color fill) {
    if (points.size() >= 3) {
      svg.append("<polygon points=\"")
          .append(coordinates(points))
          .append('"')
          .append(attributes(fill, null))
          .append("/>\n");
    }
  }

  @Override
  public void circle(double x, double y, double radius, Color fill, Stroke stroke) {
    svg.append(
        format(
            "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\"%s/>\n",
            x, y, radius, attributes(fill, stroke)));
  }

  @Override
  public void rectangle(PixelBox box, Color fill, Stroke stroke) {
    svg.append(
        format(
            "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"%s/>\n",
            box.x(), box.y(), box.width(), box.height(), attributes(fill, stroke)));
  }

  @Override
  public void text(double x, double y, String text, TextStyle style) {
    svg.append(format("<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\"", x, y, style.size()));
    if (style.bold()) {
      svg.append(" font-weight=\"bold\"");
    }
    if (style.anchor() != TextStyle.Anchor.START) {
      svg.append(" text-anchor=\"")
          .append(style.anchor().name().toLowerCase(Locale.ROOT))
          .append('"');
    }
    svg.append(attributes(style.color(), null))
        .append('>')
        .append(SvgEscapes.escaped(text))
        .append("</text>\n");
  }

  @Override
  public void clipped(PixelBox box, Runnable content) {
    clips++;
    svg.append(format("<clipPath id=\"clip%d\">", clips));
    svg.append(
        format(
            "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/></clipPath>\n",
            box.x(), box.y(), box.width(), box.height()));
    svg.append(format("<g clip-path=\"url(#clip%d)\">\n", clips));
    content.run();
    svg.append("</g>\n");
  }

  private static String coordinates(List<Pixel> points) {
    StringBuilder text = new StringBuilder();
    for (Pixel p : points) {
      text.append(text.length() == 0 ? "" : " ").append(format("%.1f,%.1f", p.x(), p.y()));
    }
    return text.toString();
  }

  private static String attributes(Color fill, Stroke stroke) {
    StringBuilder text = new StringBuilder();
    if (fill != null) {
      text.append(paint("fill", fill));
    }
    if (stroke != null) {
      text.append(paint("stroke", stroke.color()))
          .append(format(" stroke-width=\"%.2f\"", stroke.width()));
      if (stroke.dash() > 0.0) {
        text.append(format(" stroke-dasharray=\"%.1f\"", stroke.dash()));
      }
    }
    return text.toString();
  }

  private static String paint(String what, Color color) {
    String text =
        format(" %s=\"#%02x%02x%02x\"", what, color.getRed(), color.getGreen(), color.getBlue());
    return color.getAlpha() == OPAQUE
        ? text
        : text + format(" %s-opacity=\"%.3f\"", what, color.getAlpha() / (double) OPAQUE);
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
