package org.u2sa.report.page;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.JsonText;

/**
 * A chart of a run: lines, and optionally a ±2 σ band around zero.
 *
 * @param title quantity shown, the same in all runs
 * @param unit unit of the values; empty if none
 * @param lines the quantities
 * @param sigma standard deviation; null if none
 */
public record Chart(String title, String unit, List<Trace> lines, Trace sigma) {
  /** Whether the chart contains data. */
  public boolean isEmpty() {
    return lines.stream().allMatch(line -> line.size() == 0)
        && (sigma == null || sigma.size() == 0);
  }

  /** JSON content for the page. */
  public JsonText json() {
    List<JsonText> all = new ArrayList<>();
    for (Trace line : lines) {
      if (line.size() > 0) {
        all.add(line.json());
      }
    }
    JsonText json = new JsonText().put("title", title).put("unit", unit).put("lines", all);
    return sigma == null || sigma.size() == 0 ? json : json.put("sigma", sigma.json());
  }
}
