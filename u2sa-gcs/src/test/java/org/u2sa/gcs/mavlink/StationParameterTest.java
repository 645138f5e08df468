package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Configuration variables as parameters, in both encodings. */
class StationParameterTest {
  private final BridgeKit kit = configured(Identity.PX4);

  private static BridgeKit configured(Identity identity) {
    BridgeKit kit = new BridgeKit(identity, VehicleKind.ROVER);
    kit.says(
        new ConfigurationResponse()
            .serviceName("SafetyManager")
            .variables(
                List.of(
                    variable("BRAKING", "double", "0.1"),
                    variable("RATE LIMIT", "int", "-1"),
                    variable("ARM AT START", "boolean", "true"),
                    variable("ON FENCE", "string", "RETURN")
                        .choices(List.of("HOLD", "RETURN", "STOP")),
                    variable("FENCE", "string", "fence.xml"))));
    return kit;
  }

  private static ConfigurationVariable variable(String name, String type, String value) {
    return new ConfigurationVariable().name(name).variableType(type).value(value);
  }

  private static List<ParamValue> list(BridgeKit kit) {
    kit.send(ParamRequestList.builder().targetSystem(1).targetComponent(1).build());
    kit.advance(10.0);
    return kit.received(ParamValue.class);
  }

  private static void set(BridgeKit kit, String name, float value, MavParamType type) {
    kit.send(
        ParamSet.builder()
            .targetSystem(1)
            .targetComponent(1)
            .paramId(name)
            .paramValue(value)
            .paramType(type)
            .build());
  }

  private static void answer(BridgeKit kit, boolean accepted, String reason) {
    ConfigurationTransaction order = kit.orders(ConfigurationTransaction.class).get(0);
    kit.says(
        new ConfigurationTransactionResult()
            .requestId(order.requestId())
            .serviceName(order.serviceName())
            .accepted(accepted)
            .reason(reason)
            .assignments(new ArrayList<>(order.assignments()))
            .author("tester"));
    kit.step();
  }

  @Test
  void list_allButFreeTexts_hasConstantCountAndDenseIndices() {
    List<ParamValue> values = list(kit);
    assertThat(values).extracting(ParamValue::paramCount).containsOnly(4);
    assertThat(values.stream().map(ParamValue::paramIndex).collect(Collectors.toList()))
        .isEqualTo(IntStream.range(0, 4).boxed().collect(Collectors.toList()));
    assertThat(values)
        .extracting(ParamValue::paramId)
        .containsExactly("SAFM_ARM_AT_STRT", "SAFM_BRAKING", "SAFM_ON_FENCE", "SAFM_RATE_LIMIT");
  }

  @Test
  void list_integers_areBitsAsPx4AndNumbersAsArduPilot() {
    float px4 = list(kit).get(3).paramValue();
    assertThat(Float.floatToRawIntBits(px4)).isEqualTo(-1); // a NaN whose bits must survive
    assertThat(Float.floatToRawIntBits(list(kit).get(2).paramValue())).isEqualTo(1);
    assertThat(list(configured(Identity.ARDUPILOT)).get(3).paramValue()).isEqualTo(-1.0f);
  }

  @Test
  void set_accepted_answersWithTheNewValue() {
    set(kit, "SAFM_BRAKING", 0.7f, MavParamType.MAV_PARAM_TYPE_REAL32);
    ConfigurationTransaction order = (ConfigurationTransaction) kit.published.get(0);
    assertThat(order.serviceName()).isEqualTo("SafetyManager");
    assertThat(order.assignments().get(0).value()).isEqualTo("0.7"); // not 0.69999998807
    answer(kit, true, "");
    assertThat(kit.received(ParamValue.class).get(0).paramValue()).isEqualTo(0.7f);
    kit.send(read("SAFM_BRAKING", -1)); // before the service has sent its new configuration
    assertThat(kit.received(ParamValue.class).get(0).paramValue()).isEqualTo(0.7f);
  }

  @Test
  void set_refusedByTheService_answersWithTheOldValueAndTheReason() {
    set(kit, "SAFM_BRAKING", -1.0f, MavParamType.MAV_PARAM_TYPE_REAL32);
    answer(kit, false, "-1.0 is not above 0");
    assertThat(kit.received(ParamValue.class).get(0).paramValue()).isEqualTo(0.1f);
    assertThat(kit.texts())
        .isEqualTo("SAFM_BRAKING (SafetyManager, BRAKING) not set: -1.0 is not above 0");
  }

  @Test
  void set_choiceByIndex_becomesItsText() {
    set(kit, "SAFM_ON_FENCE", Float.intBitsToFloat(2), MavParamType.MAV_PARAM_TYPE_INT32);
    assertThat(kit.orders(ConfigurationTransaction.class).get(0).assignments().get(0).value())
        .isEqualTo("STOP");
    set(kit, "SAFM_ON_FENCE", Float.intBitsToFloat(3), MavParamType.MAV_PARAM_TYPE_INT32);
    assertThat(kit.orders(ConfigurationTransaction.class)).isEmpty();
    assertThat(kit.texts()).contains("expected 0 = HOLD, 1 = RETURN, 2 = STOP");
  }

  @Test
  void set_notFinite_isNotOrdered() {
    set(kit, "SAFM_BRAKING", Float.NaN, MavParamType.MAV_PARAM_TYPE_REAL32);
    set(kit, "SAFM_NONE", 1.0f, MavParamType.MAV_PARAM_TYPE_REAL32);
    assertThat(kit.orders(ConfigurationTransaction.class)).isEmpty();
    assertThat(kit.texts()).contains("a finite number").contains("no parameter \"SAFM_NONE\"");
  }

  @Test
  void read_byNameIndexAndHash() {
    kit.send(read("SAFM_BRAKING", -1));
    kit.send(read("", 1));
    assertThat(kit.received(ParamValue.class))
        .extracting(ParamValue::paramId)
        .containsExactly("SAFM_BRAKING", "SAFM_BRAKING");
    kit.send(read("_HASH_CHECK", -1));
    float before = kit.received(ParamValue.class).get(0).paramValue();
    kit.says(
        new ConfigurationResponse()
            .serviceName("Other")
            .variables(List.of(variable("GAIN", "double", "1"))));
    kit.send(read("_HASH_CHECK", -1));
    assertThat(kit.received(ParamValue.class).get(0).paramValue()).isNotEqualTo(before);
  }

  private static ParamRequestRead read(String name, int index) {
    return ParamRequestRead.builder()
        .targetSystem(1)
        .targetComponent(1)
        .paramId(name)
        .paramIndex(index)
        .build();
  }
}
