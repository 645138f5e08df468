package org.u2sa.core.launch;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.XmlElement;

/** Delivery of messages between the services of one process. */
public enum Delivery {
  /**
   * The publisher puts them into the subscribers' inboxes; the broker gets copies for other
   * processes.
   */
  DIRECT,
  /** Every message goes to the MQTT broker and back (thesis 3.2.1). */
  BROKER;

  private static final String ATTRIBUTE = "delivery";

  static Delivery of(XmlElement communication) {
    String text = communication.optionalAttribute(ATTRIBUTE).orElse(DIRECT.text());
    List<String> known = Arrays.stream(values()).map(Delivery::text).collect(Collectors.toList());
    if (!known.contains(text)) {
      throw communication.error(
          String.format(
              "%s \"%s\": expected one of %s", ATTRIBUTE, text, String.join(", ", known)));
    }
    return values()[known.indexOf(text)];
  }

  private String text() {
    return name().toLowerCase(Locale.ROOT);
  }
}
