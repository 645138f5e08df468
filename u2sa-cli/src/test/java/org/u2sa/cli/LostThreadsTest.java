package org.u2sa.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

class LostThreadsTest {
  private final StringWriter err = new StringWriter();

  private void end(Throwable thrown, String className) {
    thrown.setStackTrace(new StackTraceElement[] {new StackTraceElement(className, "run", "", 1)});
    new Main.LostThreads(new PrintWriter(err)).uncaughtException(new Thread("MQTT Con: x"), thrown);
  }

  @Test
  void uncaught_pahosRaceAtItsEnd_isALine() {
    end(
        new NullPointerException("clientState"),
        "org.eclipse.paho.client.mqttv3.internal.CommsReceiver");

    assertThat(err.toString().lines())
        .containsExactly(
            "u2sa: thread MQTT Con: x ended: java.lang.NullPointerException: clientState");
  }

  @Test
  void uncaught_anyOther_hasItsTrace() {
    end(new IllegalStateException("bug"), "org.u2sa.core.Bug");
    end(new OutOfMemoryError("heap"), "org.eclipse.paho.client.mqttv3.internal.CommsReceiver");

    assertThat(err.toString())
        .contains("at org.u2sa.core.Bug.run", "at org.eclipse.paho.client.mqttv3.internal");
  }
}
