package org.u2sa.flightgear.protocol;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The two XML files that define the protocol for FlightGear, generated from {@link OutField} and
 * {@link InField}.
 */
public final class ProtocolFiles {
  /**
   * Name of the protocol that FlightGear sends: the last argument of {@code
   * --generic=socket,out,…}.
   */
  public static final String OUT = "u2sa-out";

  /** Name of the protocol that FlightGear receives. */
  public static final String IN = "u2sa-in";

  static final String FORMAT = "%.9f"; // 1e-9° of latitude is 0.1 mm

  private ProtocolFiles() {}

  /** Content of {@code Protocol/u2sa-out.xml}. */
  public static String out() {
    StringBuilder chunks = new StringBuilder();
    for (OutField field : OutField.values()) {
      chunks.append(chunk(field.name(), field.node(), "        <format>" + FORMAT + "</format>\n"));
    }
    return file("output", chunks.toString());
  }

  /** Content of {@code Protocol/u2sa-in.xml}. */
  public static String in() {
    StringBuilder chunks = new StringBuilder();
    for (InField field : InField.values()) {
      chunks.append(chunk(field.name(), field.node(), ""));
    }
    return file("input", chunks.toString());
  }

  /**
   * Writes both files to the directory {@code Protocol} of a data directory, creating it if absent.
   * FlightGear finds them with {@code --data=DIR}.
   *
   * @throws IOException if they cannot be written; the message names the file
   */
  public static void writeTo(Path dataDirectory) throws IOException {
    Path directory = Files.createDirectories(dataDirectory.resolve("Protocol"));
    write(directory.resolve(OUT + ".xml"), out());
    write(directory.resolve(IN + ".xml"), in());
  }

  private static void write(Path file, String content) throws IOException {
    try {
      Files.write(file, content.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IOException(file + ": cannot be written: " + e.getMessage(), e);
    }
  }

  private static String file(String direction, String chunks) {
    return """
        <?xml version="1.0" encoding="UTF-8"?>
        <!-- Written by U2SA from its description of the fields (org.u2sa.flightgear.protocol); do not edit. -->
        <PropertyList>
          <generic>
            <DIRECTION>
              <binary_mode>false</binary_mode>
              <line_separator>newline</line_separator>
              <var_separator>,</var_separator>
        CHUNKS    </DIRECTION>
          </generic>
        </PropertyList>
        """
        .replace("DIRECTION", direction)
        .replace("CHUNKS", chunks);
  }

  private static String chunk(String name, String node, String format) {
    return """
              <chunk>
                <name>%s</name>
                <type>double</type>
        %s        <node>%s</node>
              </chunk>
        """
        .formatted(name, format, node);
  }
}
