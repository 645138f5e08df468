package org.u2sa.interfaces.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.BadInputException;

/** XML that points outside of itself, at files or over the network: nothing is opened or asked. */
@Timeout(30)
class OutsideFilesTest {
  @TempDir Path folder;
  private ServerSocket listener;

  @BeforeEach
  void listen() throws IOException {
    listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    listener.setSoTimeout(1); // a connection that was made waits in the backlog
  }

  @AfterEach
  void close() throws IOException {
    listener.close();
  }

  private void assertNobodyConnected() {
    assertThatThrownBy(() -> listener.accept().close()).isInstanceOf(SocketTimeoutException.class);
  }

  /** DTDs; PORT stands for the listener's, which never answers, SECRET for a file beside. */
  static Stream<String> doctypes() {
    return Stream.of(
        "<!DOCTYPE mission SYSTEM 'http://127.0.0.1:PORT/p.dtd'>",
        "<!DOCTYPE mission PUBLIC '-//X//Y' 'http://127.0.0.1:PORT/p.dtd'>",
        "<!DOCTYPE mission [<!ENTITY % p SYSTEM 'http://127.0.0.1:PORT/p.dtd'> %p;]>",
        "<!DOCTYPE mission [<!ENTITY % f SYSTEM 'SECRET'>"
            + "<!ENTITY % d SYSTEM 'http://127.0.0.1:PORT/d'> %f; %d;]>",
        "<!DOCTYPE mission [<!ENTITY e SYSTEM 'http://127.0.0.1:PORT/e'>]>",
        "<!DOCTYPE mission [<!ENTITY e SYSTEM 'SECRET'>]>",
        "<!DOCTYPE mission [<!NOTATION n SYSTEM 'http://127.0.0.1:PORT/n'>"
            + "<!ENTITY u SYSTEM 'http://127.0.0.1:PORT/u' NDATA n>]>",
        "<!DOCTYPE mission SYSTEM 'jar:http://127.0.0.1:PORT/a.jar!/p.dtd'>",
        "<!DOCTYPE mission SYSTEM 'ftp://127.0.0.1:PORT/p.dtd'>",
        "<!DOCTYPE mission SYSTEM 'SECRET'>",
        "<!DOCTYPE mission [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;'>]>",
        "<!DOCTYPE mission>");
  }

  @ParameterizedTest
  @MethodSource("doctypes")
  void read_doctype_isRefusedInItsLineAndNobodyIsAsked(String doctype) throws IOException {
    Path secret = Files.writeString(folder.resolve("secret"), "<!ENTITY told 'the-secret'>");
    String dtd =
        doctype
            .replace("PORT", String.valueOf(listener.getLocalPort()))
            .replace("SECRET", secret.toUri().toString());
    Path file = folder.resolve("m.xml");
    Files.writeString(file, "<?xml version='1.0'?>\n" + dtd + "\n<mission>&e;</mission>\n");

    assertThatThrownBy(() -> XmlReader.read(file, "mission"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(file + ", line 2: a DOCTYPE is not allowed here");
    assertNobodyConnected();
  }

  @Test
  void read_whatOtherReadersWouldFollow_isPlainText() {
    String server = "http://127.0.0.1:" + listener.getLocalPort() + "/";
    String text =
        "<?xml-stylesheet type='text/xsl' href='"
            + server
            + "s.xsl'?>\n<mission xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'"
            + " xsi:noNamespaceSchemaLocation='"
            + server
            + "m.xsd'>\n<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='"
            + server
            + "i.xml'/></mission>";

    XmlElement mission =
        XmlReader.read(
            new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "m.xml", "mission");

    assertThat(mission.children()).extracting(XmlElement::name).containsExactly("xi:include");
    assertThatThrownBy(() -> mission.refuseUnknownAttributes("name"))
        .hasMessageStartingWith("m.xml, line 2, <mission>: unknown attribute \"xsi:");
    assertThatThrownBy(() -> mission.refuseUnknownChildren("home"))
        .hasMessageStartingWith("m.xml, line 3, <xi:include>: unknown element in <mission>");
    assertNobodyConnected();
  }
}
