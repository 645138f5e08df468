package org.u2sa.cli.doctor;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Checks for programs needed for some uses: Mosquitto, FlightGear, a virtual screen, Android's
 * tools.
 */
final class ToolChecks {
  private final Programs programs;
  private final Map<String, String> environment;
  private final Path gamesFolder;

  ToolChecks(Programs programs, Map<String, String> environment) {
    this(programs, environment, Path.of("/usr/games"));
  }

  /** Searches the games folder after the PATH, as scripts/flightgear/start does. */
  ToolChecks(Programs programs, Map<String, String> environment, Path gamesFolder) {
    this.programs = programs;
    this.environment = environment;
    this.gamesFolder = gamesFolder;
  }

  List<Finding> all() throws InterruptedException {
    return List.of(
        tool(
            "Mosquitto",
            "mosquitto",
            "needed only to replace the embedded broker: apt install mosquitto",
            "-h"),
        tool(
            "mosquitto_sub",
            "mosquitto_sub",
            "useful for listening without U2SA: apt install mosquitto-clients",
            "--version"),
        tool(
            "FlightGear",
            "fgfs",
            "needed only by ./u2sa fly: scripts/flightgear/install, docs/flightgear.md",
            "--version"),
        screen(),
        tool(
            "Python",
            "python3",
            "needed by ./u2sa apk and the Python client: apt install python3",
            "--version"),
        tool("adb", "adb", "needed to install the app on a phone: apt install adb", "--version"),
        androidSdk());
  }

  private Finding tool(String subject, String program, String advice, String argument)
      throws InterruptedException {
    Optional<Path> file = programs.find(program).or(() -> games(program));
    if (file.isEmpty()) {
      return Finding.optional(subject, "no " + program + " on the PATH", advice);
    }
    String version = programs.firstLine(file.get(), argument).orElse("reports no version");
    return Finding.ok(subject, file.get() + ", " + version);
  }

  /** Debian's folder of FlightGear, which is not on every account's PATH. */
  private Optional<Path> games(String program) {
    return Optional.of(gamesFolder.resolve(program)).filter(Files::isExecutable);
  }

  private Finding screen() {
    String display = environment.getOrDefault("DISPLAY", "");
    if (!display.isEmpty()) {
      return Finding.ok("screen", "DISPLAY is " + display);
    }
    return programs
        .find("Xvfb")
        .map(file -> Finding.ok("screen", "none, but " + file + " creates a virtual one"))
        .orElse(
            Finding.optional(
                "screen",
                "none, and no Xvfb on the PATH",
                "needed only by FlightGear without a screen: apt install xvfb"));
  }

  private Finding androidSdk() {
    for (String name : List.of("ANDROID_HOME", "ANDROID_SDK_ROOT")) {
      String folder = environment.getOrDefault(name, "");
      if (!folder.isEmpty()) {
        return Files.isDirectory(Path.of(folder, "platforms"))
            ? Finding.ok("Android SDK", folder)
            : Finding.warning(
                "Android SDK",
                name + " is " + folder + ", which has no folder platforms",
                "install a platform with sdkmanager, or unset " + name);
      }
    }
    return Finding.optional(
        "Android SDK",
        "neither ANDROID_HOME nor ANDROID_SDK_ROOT is set",
        "needed only by Gradle; ./u2sa apk does not need it (docs/android-build.md)");
  }
}
