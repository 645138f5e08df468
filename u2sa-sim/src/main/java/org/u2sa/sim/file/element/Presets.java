package org.u2sa.sim.file.element;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/**
 * Data-sheet values by product, from {@code presets.xml}: an element of a vehicle file with the
 * attribute {@code preset} needs only the values that differ.
 */
public final class Presets {
  static final String ATTRIBUTE = "preset";

  private static final String NAME = "name";
  private static final String FILE = "presets.xml";
  private static final XmlElement ROOT = read();

  private Presets() {}

  private static XmlElement read() {
    try (InputStream in = Presets.class.getResourceAsStream(FILE)) {
      return XmlReader.read(in, FILE, "presets");
    } catch (IOException e) {
      throw new IllegalStateException(FILE + " cannot be read", e);
    }
  }

  /** All presets: elements with a name and a source. */
  public static List<XmlElement> all() {
    return ROOT.children();
  }

  public static boolean exist(String element) {
    return !ROOT.children(element).isEmpty();
  }

  /**
   * A preset.
   *
   * @param user element that names it
   * @throws org.u2sa.interfaces.BadInputException if it is unknown; lists the known presets
   */
  public static FileElement find(XmlElement user, String name) {
    List<XmlElement> candidates = ROOT.children(user.name());
    return candidates.stream()
        .filter(each -> each.attribute(NAME).equals(name))
        .findFirst()
        .map(each -> new FileElement(each, NAME, "source"))
        .orElseThrow(
            () -> {
              List<String> names = candidates.stream().map(each -> each.attribute(NAME)).toList();
              return user.error(
                  ("preset \"" + name + "\": expected one of " + String.join(", ", names))
                      + NearestNames.didYouMean(name, names));
            });
  }
}
