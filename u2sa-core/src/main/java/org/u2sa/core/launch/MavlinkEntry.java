package org.u2sa.core.launch;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * A link to MAVLink ground stations in a system file: {@code <mavlink link="tcp:5760" as="px4"/>}.
 *
 * @param link the link with its options, as in --mavlink
 * @param element its XML element, for error messages
 */
public record MavlinkEntry(String link, XmlElement element) {
  private static final String USUAL_LINK = "udp:127.0.0.1:14550";
  private static final List<String> OPTIONS = List.of("as", "type", "id", "baud");
  private static final List<String> FILES = List.of("key", "logs"); // beside the system file

  static MavlinkEntry read(Path file, XmlElement element) {
    element.refuseUnknownAttributes("link", "as", "type", "id", "baud", "key", "logs");
    StringBuilder link = new StringBuilder(element.optionalAttribute("link").orElse(USUAL_LINK));
    for (String option : OPTIONS) {
      element
          .optionalAttribute(option)
          .ifPresent(value -> link.append(',').append(option).append('=').append(value));
    }
    for (String option : FILES) {
      element
          .optionalAttribute(option)
          .map(file::resolveSibling)
          .ifPresent(path -> link.append(',').append(option).append('=').append(path));
    }
    return new MavlinkEntry(link.toString(), element);
  }
}
