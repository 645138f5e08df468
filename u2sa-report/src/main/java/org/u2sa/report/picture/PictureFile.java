package org.u2sa.report.picture;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.bootstrap.DOMImplementationRegistry;
import org.w3c.dom.ls.DOMImplementationLS;
import org.w3c.dom.ls.LSOutput;

/** Writes drawings as SVG or PNG, headless. */
public final class PictureFile {
  private static final int SVG_DECIMALS = 2;

  private PictureFile() {}

  /**
   * Reason why this Java cannot draw, or empty: without fonts or font libraries, it fails at the
   * first text with varying errors.
   */
  public static Optional<String> obstacle() {
    try {
      image(1, 1, graphics -> graphics.drawString("x", 0, 1));
      return Optional.empty();
    } catch (RuntimeException | LinkageError | InternalError e) {
      return Optional.of(
          "this Java cannot draw text ("
              + (e.getCause() == null ? e : e.getCause())
              + "); a font may help, e.g. apt install fonts-dejavu-core");
    }
  }

  public static void png(OutputStream out, int width, int height, Consumer<Graphics2D> content)
      throws IOException {
    png(out, image(width, height, content));
  }

  /** Writes an image that was drawn elsewhere. */
  public static void png(OutputStream out, BufferedImage image) throws IOException {
    // ImageIO's own cache file needs a shutdown hook, which an interrupted run cannot have.
    try (ImageOutputStream png = new MemoryCacheImageOutputStream(out)) {
      if (!ImageIO.write(image, "png", png)) {
        throw new IOException("this Java has no writer for PNG");
      }
    }
  }

  private static BufferedImage image(int width, int height, Consumer<Graphics2D> content) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    content.accept(graphics);
    graphics.dispose();
    return image;
  }

  /**
   * @param title title for viewers and screen readers
   */
  public static void svg(
      Writer out, String title, int width, int height, Consumer<Graphics2D> content) {
    Document document = document();
    SVGGeneratorContext context = SVGGeneratorContext.createDefault(document);
    context.setComment(null);
    context.setPrecision(SVG_DECIMALS);
    SVGGraphics2D graphics = new SVGGraphics2D(context, false);
    graphics.setSVGCanvasSize(new Dimension(width, height));
    content.accept(graphics);
    Element root = graphics.getRoot();
    root.setAttribute("viewBox", "0 0 " + width + " " + height);
    Element name = document.createElementNS(SVGGraphics2D.SVG_NAMESPACE_URI, "title");
    name.setTextContent(title);
    root.insertBefore(name, root.getFirstChild());
    write(root, out);
  }

  private static Document document() {
    try {
      return DOMImplementationRegistry.newInstance()
          .getDOMImplementation("XML 3.0 LS 3.0")
          .createDocument(SVGGraphics2D.SVG_NAMESPACE_URI, "svg", null);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("this Java has no DOM", e);
    }
  }

  /** Omits the DOCTYPE that Batik would write, which some readers fetch from the network. */
  private static void write(Element root, Writer out) {
    DOMImplementationLS dom = (DOMImplementationLS) root.getOwnerDocument().getImplementation();
    LSOutput output = dom.createLSOutput();
    output.setEncoding("UTF-8");
    output.setCharacterStream(out);
    dom.createLSSerializer().write(root, output);
  }
}
