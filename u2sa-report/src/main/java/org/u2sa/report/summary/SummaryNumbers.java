package org.u2sa.report.summary;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.interfaces.JsonText;

/**
 * A JSON object with numbers rounded to thousandths. A missing number is {@code null} with a reason
 * in {@code absent}, since JSON has no NaN.
 *
 * @param absent reasons for missing numbers by key, for all parts of a summary
 * @param part name of this part in the reasons; empty for the summary itself
 */
record SummaryNumbers(JsonText json, Map<String, String> absent, String part) {
  private static final int DECIMALS = 3;

  SummaryNumbers(Map<String, String> absent, String part) {
    this(new JsonText(), absent, part);
  }

  SummaryNumbers put(String key, Object value) {
    json.put(key, value);
    return this;
  }

  SummaryNumbers number(String key, double value) {
    return put(key, BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN));
  }

  SummaryNumbers number(String key, OptionalDouble value, String reasonIfAbsent) {
    if (value.isPresent()) {
      return number(key, value.getAsDouble());
    }
    absent.put(part.isEmpty() ? key : part + ": " + key, reasonIfAbsent);
    json.putNull(key);
    return this;
  }

  /** The object with the reasons for all numbers missing so far, ending with a line feed. */
  String text() {
    JsonText reasons = new JsonText();
    absent.forEach(reasons::put);
    return put("absent", reasons).json + "\n";
  }
}
