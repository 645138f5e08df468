package org.u2sa.core.launch;

import java.io.IOException;
import java.util.regex.Pattern;

/**
 * A supervisor's report of a process that ended or could not be started, and the health monitor's
 * conclusion from it. Its texts also appear in reports and logs.
 */
public final class ProcessFailure {
  private static final String ENDED = "its process has ended with exit code ";
  private static final int BAD_INPUT = 2; // exit code of the command line if no service was started
  private static final String SHORT_OF_RESOURCES = "too little memory, processes or open files";

  /** Linux errors as worded by Java: EAGAIN, ENOMEM, ENFILE and EMFILE. */
  private static final Pattern NO_RESOURCES = Pattern.compile("error=(11|12|23|24)\\b");

  private ProcessFailure() {}

  /** Text for a process that has ended. */
  public static String ended(int exitCode) {
    return ENDED + exitCode;
  }

  /** Whether the ended process would reject its input again if restarted. */
  public static boolean isOfInput(String words) {
    return words.equals(ended(BAD_INPUT));
  }

  /** Text for a process that could not be started. */
  public static String notStarted(IOException cause) {
    boolean isShort = NO_RESOURCES.matcher("" + cause.getMessage()).find();
    return "the process cannot be started: "
        + (isShort ? SHORT_OF_RESOURCES + ": " : "")
        + cause.getMessage();
  }

  /** Whether the start failed for a lack of resources, which may be temporary. */
  public static boolean isOfResources(String words) {
    return words.contains(SHORT_OF_RESOURCES);
  }
}
