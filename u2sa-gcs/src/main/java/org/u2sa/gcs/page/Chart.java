package org.u2sa.gcs.page;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.JsonText;

/**
 * A chart of a run: lines, and a band of twice a standard deviation around zero where there is one.
 *
 * @param title what is shown, the same in all runs
 * @param unit of the values; empty: none
 * @param lines the quantities
 * @param sigma standard deviation, or null
 */
public record Chart(String title, String unit, List<Trace> lines, Trace sigma) {
  /** Whether there is anything to draw. */
  public boolean isEmpty() {
    return lines.stream().allMatch(line -> line.size() == 0)
        && (sigma == null || sigma.size() == 0);
  }

  /** For the page. */
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
