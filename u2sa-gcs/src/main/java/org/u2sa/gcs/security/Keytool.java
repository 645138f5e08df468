package org.u2sa.gcs.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.command.RunFailedException;

/** The JDK's tool for keys and certificates, run as a process. */
final class Keytool {
  /**
   * Of every key store here. It protects nothing, and need not: the files are their owner's alone,
   * and keytool wants one.
   */
  static final String PASSWORD = "u2sa-local";

  private Keytool() {}

  /**
   * Runs it on a PKCS #12 store.
   *
   * @param words its command and options without spaces in them
   * @param more options that may hold spaces
   * @return what it printed
   */
  static String run(String words, List<String> more, Path store)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "keytool").toString());
    command.addAll(List.of(words.split(" ")));
    command.addAll(more);
    command.addAll(
        List.of(
            "-storetype", "PKCS12", "-keystore", store.toString(), "-storepass:env", "U2SA_STORE"));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("U2SA_STORE", PASSWORD);
    Process process = builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new RunFailedException(
          "keytool " + words + " failed on " + store + ": " + printed.trim());
    }
    return printed;
  }
}
