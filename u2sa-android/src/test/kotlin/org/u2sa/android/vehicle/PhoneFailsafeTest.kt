package org.u2sa.android.vehicle

import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.u2sa.android.vehicle.PhoneCondition.Heat
import org.u2sa.android.vehicle.PhoneFailsafe.Hazard

class PhoneFailsafeTest {
    private val failsafe = PhoneFailsafe(15.0)
    private val good = PhoneCondition.Reading(80.0, false, Heat.LIGHT)

    @Test
    fun hazards_allWell_none() = assertThat(failsafe.hazards(good, true, 100_000)).isEmpty()

    @Test
    fun hazards_nothingKnownOfBoardBatteryHeat_areNotHeldAgainstIt() {
        val silent = PhoneCondition.Reading(null, false, null)
        assertThat(failsafe.hazards(silent, null, 100_000)).isEmpty()
    }

    @Test
    fun hazards_boardGone_isFirst() =
        assertThat(failsafe.hazards(good, false, null)).containsExactly(Hazard.BOARD_LOST, Hazard.POSITION_LOST)

    @ParameterizedTest
    @CsvSource("15.0, false, false", "14.9, false, true", "14.9, true, false")
    fun hazards_battery_countsBelowTheLimitUnlessCharged(percent: Double, charging: Boolean, low: Boolean) {
        val hazards = failsafe.hazards(PhoneCondition.Reading(percent, charging, null), true, 0)
        assertThat(hazards.contains(Hazard.BATTERY_LOW)).isEqualTo(low)
    }

    @ParameterizedTest
    @CsvSource("MODERATE, false", "SEVERE, true", "SHUTDOWN, true")
    fun hazards_heat_countsFromSevereOn(heat: Heat, hot: Boolean) {
        val hazards = failsafe.hazards(PhoneCondition.Reading(80.0, false, heat), true, 0)
        assertThat(hazards.contains(Hazard.TOO_HOT)).isEqualTo(hot)
    }

    @ParameterizedTest
    @CsvSource("3000000, false", "3000001, true")
    fun hazards_positionsAge_countsAfterThreeSeconds(ageMicros: Long, lost: Boolean) {
        assertThat(failsafe.hazards(good, true, ageMicros).contains(Hazard.POSITION_LOST)).isEqualTo(lost)
    }
}
