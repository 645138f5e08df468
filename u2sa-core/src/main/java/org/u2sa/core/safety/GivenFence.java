package org.u2sa.core.safety;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;

/**
 * A fence and where it comes from.
 *
 * @param file its file, or the operator who ordered it
 * @param xml its text, without an XML declaration
 * @param whole as its text has it
 * @param fence the fence in force, shrunk by the margin
 */
record GivenFence(String file, String xml, Fence whole, Fence fence) {
  private static final int MAX_CORNERS = 2_000; // in a message
  private static final double OUTLINE_M = 0.1; // tolerance of published outlines

  /**
   * Reads a fence.
   *
   * @throws BadInputException naming file, line, element and what was expected
   */
  static GivenFence of(String file, String text, double marginM) {
    String xml = withoutDeclaration(text);
    ByteArrayInputStream in = new ByteArrayInputStream(xml.getBytes(UTF_8));
    Fence given = FenceReader.read(XmlReader.read(in, file, "fence"));
    try {
      return new GivenFence(file, xml, given, given.drawnInBy(marginM));
    } catch (IllegalArgumentException e) {
      throw new BadInputException(
          file + ": " + SafetyVariables.FENCE_MARGIN + ": " + e.getMessage(), e);
    }
  }

  /**
   * Removes the XML declaration, whose encoding was the file's, but keeps its line break, so that
   * errors refer to the file's lines.
   */
  private static String withoutDeclaration(String text) {
    int end = text.startsWith("<?xml") ? text.indexOf("?>") : -1;
    return end < 0 ? text : text.substring(end + 2);
  }

  /** Copy with a different margin; throws like {@link #of}. */
  GivenFence drawnInBy(double marginM) {
    return of(file, xml, marginM);
  }

  /** The fence as published: no folder of its file, as a recording may be re-run elsewhere. */
  FenceState state(double marginM) {
    FenceState state = new FenceState().file(new File(file).getName()).margin(marginM);
    state.rally(
        fence.rally().stream()
            .filter(point -> fence.objection(point).isEmpty())
            .map(Fence.RallyPoint::waypoint)
            .collect(Collectors.toList()));
    // Up to the margin, so that ways home never enter the file's areas.
    for (double tolerance : new double[] {OUTLINE_M, 0.5 * marginM, marginM}) {
      if (fence.corners(tolerance) <= MAX_CORNERS) {
        state.keepIn(shapes("keep-in", fence.keepIn(tolerance)));
        state.keepOut(shapes("keep-out", fence.keepOut(tolerance)));
        break;
      }
    }
    fence.floorM.ifPresent(state::lowest);
    fence.ceilingM.ifPresent(state::highest);
    return xml.getBytes(UTF_8).length <= Limits.TEXT_BYTES ? state.fence(xml) : state;
  }

  private List<Polygon> shapes(String name, List<List<Point>> outlines) {
    List<Polygon> shapes = new ArrayList<>();
    for (List<Point> outline : outlines) {
      Polygon shape = new Polygon().points(outline);
      Point first = outline.get(0);
      shape.uid(name + " " + (shapes.size() + 1)).referenceFrame(fence.frame());
      shapes.add(shape.x(first.x()).y(first.y()));
    }
    return shapes;
  }
}
