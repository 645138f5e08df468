package org.u2sa.scenarios.run;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;

/**
 * A service that is to be swapped in a run.
 *
 * @param atS time since the services were started [s]
 * @param service its name
 * @param className full name of the class that takes its place
 */
public record PlannedSwap(double atS, String service, String className) {
  private static final Pattern FORM = Pattern.compile("([0-9]+(?:\\.[0-9]+)?):([^=]+)=(\\S+)");

  /**
   * Reads {@code SECONDS:SERVICE=CLASS}.
   *
   * @throws IllegalArgumentException if the text is not of that form
   */
  public static PlannedSwap parse(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      throw new IllegalArgumentException(
          "\""
              + text
              + "\" is no swap; expected SECONDS:SERVICE=CLASS, such as"
              + " 100:PathPlanner=org.u2sa.core.planning.VectorFieldPlanner");
    }
    return new PlannedSwap(Double.parseDouble(form.group(1)), form.group(2), form.group(3));
  }

  /**
   * Refuses swaps of services that do not run: nobody would obey the order.
   *
   * @param running names of the services
   * @throws BadInputException naming the services there are, and the nearest
   */
  static void requireServices(List<PlannedSwap> swaps, List<String> running) {
    for (PlannedSwap swap : swaps) {
      if (!running.contains(swap.service)) {
        throw new BadInputException(
            "--swap "
                + swap
                + ": no service \""
                + swap.service
                + "\" runs; expected one of "
                + String.join(", ", running)
                + NearestNames.didYouMean(swap.service, running));
      }
    }
  }

  /**
   * Refuses swaps for classes that are no services, before the run in which they are due.
   *
   * @throws BadInputException naming the class
   */
  static void requireClasses(List<PlannedSwap> swaps, LaunchOptions options) {
    for (PlannedSwap swap : swaps) {
      try {
        options.requireServiceClass(swap.className);
      } catch (BadInputException e) {
        throw new BadInputException("--swap " + swap + ": " + e.getMessage(), e);
      }
    }
  }

  /** As it was read. */
  @Override
  public String toString() {
    return atS + ":" + service + "=" + className;
  }
}
