package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.ShapeDescription;
import org.u2sa.messages.shape.Sphere;

class MessageTypesTest {
  private final MessageTypes types = StandardTypes.registry();

  @Test
  void chain_subclass_listsAncestorsFirst() {
    assertThat(PercentageCommand.TYPE.chain())
        .containsExactly("ActuatorCommand", "PercentageCommand");
    assertThat(Circle.TYPE.chain())
        .containsExactly("ObjectDescription", "ShapeDescription", "Circle");
  }

  @Test
  void all_everyType_isNamedAsItsClassAndMadeByCreate() {
    for (MessageType<?> type : types.all()) {
      assertThat(type.name()).isEqualTo(type.messageClass().getSimpleName());
      if (!type.isAbstract()) {
        assertThat(type.create()).isExactlyInstanceOf(type.messageClass());
        assertThat(type.create().type()).isSameAs(type);
      }
    }
  }

  @Test
  void byElementName_firstLetterOfEitherCase_isFound() {
    assertThat(types.byElementName("waypoint")).contains(Waypoint.TYPE);
    assertThat(types.byElementName("Circle")).contains(Circle.TYPE);
    assertThat(types.byElementName("wayPoint")).isEmpty();
    assertThat(types.byElementName("")).isEmpty();
  }

  @Test
  void nearest_unknownLeaf_isTheKnownAncestor() throws MalformedMessageException {
    assertThat(types.nearest(List.of("ActuatorCommand", "PercentageCommand", "Servo")))
        .isSameAs(PercentageCommand.TYPE);
    assertThat(types.nearest(List.of("GoalInformation", "Dive"))).isSameAs(GoalInformation.TYPE);
    assertThat(types.nearest(List.of("Tide"))).isSameAs(OpaqueMessage.TYPE);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ConfigurationRequest/ConfigurationTransaction",
        "ConfigurationRequest/EmergencyStop",
        "DiscoveryRequest/StopCommand",
        "Tide/StopCommand",
        "StopCommand/StopCommand",
        "PercentageCommand",
        "PercentageCommand/ActuatorCommand",
        "ActuatorCommand/Servo/PercentageCommand",
        "ActuatorCommand/PercentageCommand/StopCommand/Tide"
      })
  void nearest_ancestryThatIsNotTheTypes_isRefused(String chain) {
    assertThatThrownBy(() -> types.nearest(List.of(chain.split("/"))))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("type chain")
        .hasMessageContaining("not " + chain.replaceFirst("/Tide$", ""));
  }

  @Test
  void nearest_everyKnownTypesOwnChain_isThatType() throws MalformedMessageException {
    for (MessageType<?> type : types.all()) {
      assertThat(types.nearest(type.chain())).isSameAs(type);
    }
  }

  @Test
  void create_abstractType_isRefused() {
    assertThatThrownBy(GoalInformation.TYPE::create)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("GoalInformation is abstract: no message can have this type");
  }

  @Test
  void with_secondTypeOfTheSameName_isRefused() {
    MessageType<Sphere> impostor =
        Schema.of("Circle", Sphere.class, Sphere::new, ShapeDescription.TYPE).build();

    assertThatThrownBy(() -> types.with(List.of(impostor)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("two message types are called Circle");
  }

  @Test
  void discovered_providerOnTheClassPath_isAsked() {
    assertThat(MessageTypes.discovered().byName("Tide")).contains(EvolutionTest.Tide.TYPE);
    assertThat(types.byName("Tide")).isEmpty();
  }

  @Test
  void loadable_extensionThatIsMissing_leavesTheOthersAndSaysSo(@TempDir Path folder)
      throws IOException {
    assertThatOthersRemain(folder, "com.example.Missing", "com.example.Missing");
  }

  @ParameterizedTest
  @ValueSource(classes = {Unconfigured.class, Endless.class, Absent.class, WithoutAClass.class})
  void loadable_extensionThatFails_leavesTheOthersAndSaysSo(
      Class<? extends MessageTypeProvider> extension, @TempDir Path folder) throws IOException {
    assertThatOthersRemain(folder, extension.getName(), extension.getName() + " are missing: ");
  }

  private static void assertThatOthersRemain(Path folder, String extension, String said)
      throws IOException {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve(MessageTypeProvider.class.getName()), extension + "\n");
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    List<String> missing = new ArrayList<>();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
      thread.setContextClassLoader(loader);

      MessageTypes loadable = MessageTypes.loadable(missing::add);
      assertThat(loadable.byName("EmergencyStop")).isPresent();
      assertThat(loadable.byName("Tide")).as("another extension").isPresent();
      assertThat(missing).singleElement().asString().contains(said);
      assertThatThrownBy(MessageTypes::discovered).isInstanceOf(Throwable.class);
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  /** An extension that throws an exception. */
  public static final class Unconfigured implements MessageTypeProvider {
    @Override
    public Collection<MessageType<?>> messageTypes() {
      throw new IllegalStateException("not configured");
    }
  }

  /** An extension that throws an error. */
  public static final class Endless implements MessageTypeProvider {
    @Override
    public Collection<MessageType<?>> messageTypes() {
      throw new StackOverflowError();
    }
  }

  /** An extension that returns nothing. */
  public static final class Absent implements MessageTypeProvider {
    @Override
    public Collection<MessageType<?>> messageTypes() {
      return null;
    }
  }

  /** An extension without one of its libraries. */
  public static final class WithoutAClass implements MessageTypeProvider {
    @Override
    public Collection<MessageType<?>> messageTypes() {
      throw new NoClassDefFoundError("com/example/Missing");
    }
  }
}
