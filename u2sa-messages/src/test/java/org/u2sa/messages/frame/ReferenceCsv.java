package org.u2sa.messages.frame;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Rows of the reference values that scripts/geodesy-reference.py makes. */
public record ReferenceCsv(Map<String, String> cells) {
  /** All rows of a file. */
  public static Stream<ReferenceCsv> rows(String file) throws IOException {
    List<ReferenceCsv> rows = new ArrayList<>();
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                ReferenceCsv.class.getResourceAsStream(file), StandardCharsets.UTF_8))) {
      List<String> lines = in.lines().filter(line -> !line.startsWith("#")).toList();
      String[] names = lines.get(0).split(",");
      for (String line : lines.subList(1, lines.size())) {
        String[] values = line.split(",");
        Map<String, String> cells = new HashMap<>();
        for (int i = 0; i < names.length; i++) {
          cells.put(names[i], values[i]);
        }
        rows.add(new ReferenceCsv(cells));
      }
    }
    return rows.stream();
  }

  /** A number of the row. */
  public double number(String column) {
    return Double.parseDouble(text(column));
  }

  /** A text of the row. */
  public String text(String column) {
    if (!cells.containsKey(column)) {
      throw new IllegalArgumentException(column + " is no column of " + cells.keySet());
    }
    return cells.get(column);
  }

  /** A place from three columns. */
  public Geodetic place(String longitude, String latitude, String altitude) {
    return new Geodetic(number(longitude), number(latitude), number(altitude));
  }
}
