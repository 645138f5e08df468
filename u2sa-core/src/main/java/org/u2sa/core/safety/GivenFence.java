package org.u2sa.core.safety;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.safety.FenceState;

/**
 * A fence and where it comes from.
 *
 * @param file its file, or the operator who ordered it
 * @param xml its text, without an XML declaration
 * @param fence the fence in force, shrunk by the margin
 */
record GivenFence(String file, String xml, Fence fence) {
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
      return new GivenFence(file, xml, given.drawnInBy(marginM));
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
    fence.floorM.ifPresent(state::lowest);
    fence.ceilingM.ifPresent(state::highest);
    return xml.getBytes(UTF_8).length <= Limits.TEXT_BYTES ? state.fence(xml) : state;
  }
}
