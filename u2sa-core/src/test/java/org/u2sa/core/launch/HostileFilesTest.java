package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.mission.Mission;

/** Files that somebody wrote to do harm are refused at once, with file and line. */
@Timeout(120)
class HostileFilesTest {
  /** Would tell of a class that is loaded and run before it is known to be a service. */
  public static final class NoService {
    static {
      System.setProperty("u2sa.test.hostile", "ran");
    }

    private NoService() {}
  }

  @TempDir Path folder;
  private Path secret;

  @BeforeEach
  void write() throws IOException {
    secret = Files.writeString(folder.resolve("secret.txt"), "the-secret");
  }

  static Stream<Arguments> readersAndRoots() {
    return Stream.of(
        Arguments.of("system", "id=\"cessna\""),
        Arguments.of("configuration", ""),
        Arguments.of("mission", ""));
  }

  private ThrowingCallable reading(String root, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(root + ".xml"), text);
    return switch (root) {
      case "system" -> () -> SystemFile.read(file);
      case "configuration" -> () -> XmlConfiguration.load(file);
      default -> () -> Mission.load(file);
    };
  }

  private void refuses(String root, String text, String because) throws IOException {
    assertThatThrownBy(reading(root, text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(root + ".xml")
        .hasMessageContaining(because)
        .hasMessageNotContaining("the-secret");
  }

  @ParameterizedTest
  @MethodSource("readersAndRoots")
  void read_externalEntity_isNotFollowed(String root, String attributes) throws IOException {
    refuses(
        root,
        "<!DOCTYPE x [<!ENTITY s SYSTEM \""
            + secret.toUri()
            + "\">]>\n<"
            + root
            + " "
            + attributes
            + ">&s;</"
            + root
            + ">",
        "DOCTYPE");
  }

  @ParameterizedTest
  @MethodSource("readersAndRoots")
  void read_dtdOnAServer_nobodyIsAsked(String root, String attributes) throws IOException {
    try (ServerSocket server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      server.setSoTimeout(1); // a connection that was made waits in the backlog
      refuses(
          root,
          "<!DOCTYPE x SYSTEM \"http://127.0.0.1:"
              + server.getLocalPort()
              + "/p.dtd\">\n<"
              + root
              + " "
              + attributes
              + "/>",
          "DOCTYPE");
      assertThatThrownBy(() -> server.accept().close()).isInstanceOf(SocketTimeoutException.class);
    }
  }

  @ParameterizedTest
  @MethodSource("readersAndRoots")
  void read_billionLaughs_isRefusedAtItsDoctype(String root, String attributes) throws IOException {
    StringBuilder text = new StringBuilder("<!DOCTYPE x [<!ENTITY e0 \"ha\">\n");
    for (int i = 1; i < 30; i++) {
      text.append("<!ENTITY e")
          .append(i)
          .append(" \"&e")
          .append(i - 1)
          .append(";&e")
          .append(i - 1)
          .append(";\">\n");
    }
    text.append("]>\n<")
        .append(root)
        .append(' ')
        .append(attributes)
        .append(">&e29;</")
        .append(root)
        .append('>');
    refuses(root, text.toString(), "DOCTYPE");
  }

  @ParameterizedTest
  @MethodSource("readersAndRoots")
  void read_hugeDepth_isRefused(String root, String attributes) throws IOException {
    refuses(root, "<" + root + " " + attributes + ">" + "<a>".repeat(100_000), "nested elements");
  }

  @Test
  void start_classThatIsNoService_isRefusedBeforeItsCodeRuns() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"x\"><service class=\"" + NoService.class.getName() + "\"/></system>");
    assertThatThrownBy(() -> RunningSystem.start(SystemFile.read(file), new LaunchOptions()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("does not extend U2SAService");
    assertThat(System.getProperty("u2sa.test.hostile")).isNull();
  }
}
