package org.u2sa.interfaces.mqtt;

import java.util.Map;
import java.util.UUID;
import java.util.regex.Pattern;
import org.u2sa.interfaces.communication.TopicLevel;

/**
 * MQTT client IDs of this process: {@code <system>/<service>/<run>/<connection>}. The run ID is a
 * secret shared by a process and its child processes, by which a broker recognises them as one
 * sender. Both last levels are random and published nowhere.
 */
public final class ClientIds {
  /** Environment variable by which a process passes its run to the processes it starts. */
  public static final String ENVIRONMENT = "U2SA_RUN";

  private static final int LEVELS = 4;
  private static final int RUN = 2; // index of its level
  private static final Pattern RANDOM =
      Pattern.compile("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");
  private static final String OF_PROCESS = run(System.getenv());

  private ClientIds() {}

  /** The run in the environment, or a new one if that is absent or not a UUID. */
  static String run(Map<String, String> environment) {
    String given = environment.getOrDefault(ENVIRONMENT, "");
    return RANDOM.matcher(given).matches() ? given : UUID.randomUUID().toString();
  }

  /** The run of this process: a secret. */
  public static String run() {
    return OF_PROCESS;
  }

  public static String of(String systemId, String serviceName) {
    return String.join(
        "/",
        TopicLevel.of(systemId),
        TopicLevel.of(serviceName),
        OF_PROCESS,
        UUID.randomUUID().toString());
  }

  /** Sender of a client's messages: the run, or the whole ID if it names none. */
  public static String senderOf(String clientId) {
    String[] levels = clientId.split("/", -1);
    return levels.length == LEVELS && RANDOM.matcher(levels[RUN]).matches()
        ? levels[RUN]
        : clientId;
  }

  /** The ID without its run, for logs. */
  public static String shown(String clientId) {
    String sender = senderOf(clientId);
    return sender.equals(clientId) ? clientId : clientId.replace(sender + "/", "");
  }
}
