package org.u2sa.flightgear.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;

final class ProtocolFilesTest {
  @TempDir private Path directory;

  @Test
  void writeTo_directory_bothFilesNameTheFieldsInOrder() throws Exception {
    ProtocolFiles.writeTo(directory.resolve("data"));
    Document out = read("u2sa-out.xml");
    Document in = read("u2sa-in.xml");
    assertThat(texts(out, "node"))
        .isEqualTo(Arrays.stream(OutField.values()).map(OutField::node).toList());
    assertThat(texts(in, "node"))
        .isEqualTo(Arrays.stream(InField.values()).map(InField::node).toList());
    assertThat(texts(out, "type")).containsOnly("double").hasSize(OutField.values().length);
    assertThat(texts(out, "format")).containsOnly("%.9f").hasSize(OutField.values().length);
    assertThat(texts(in, "type")).containsOnly("double").hasSize(InField.values().length);
    assertThat(out.getElementsByTagName("output").getLength()).isEqualTo(1);
    assertThat(in.getElementsByTagName("input").getLength()).isEqualTo(1);
    assertThat(texts(out, "line_separator")).containsExactly("newline");
    assertThat(texts(in, "var_separator")).containsExactly(",");
  }

  @Test
  void writeTo_directoryThatIsAFile_namesIt() throws IOException {
    Path file = Files.createFile(directory.resolve("data"));
    assertThatThrownBy(() -> ProtocolFiles.writeTo(file))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(file.toString());
  }

  private Document read(String name) throws Exception {
    Path file = directory.resolve("data").resolve("Protocol").resolve(name);
    return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
  }

  private static List<String> texts(Document document, String tag) {
    NodeList found = document.getElementsByTagName(tag);
    return IntStream.range(0, found.getLength())
        .mapToObj(i -> found.item(i).getTextContent())
        .toList();
  }
}
