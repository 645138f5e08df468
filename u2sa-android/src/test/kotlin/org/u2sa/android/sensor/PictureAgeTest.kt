package org.u2sa.android.sensor

import android.hardware.camera2.CameraMetadata
import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.Test

class PictureAgeTest {
    @Test
    fun micros_stampOfTheClock_isTheDifference() {
        assertThat(PictureAge { 7_000_000L }.micros(2_000_000L)).isEqualTo(5_000L)
    }

    @Test
    fun micros_stampAhead_isNoAge() {
        assertThat(PictureAge { 1_000L }.micros(2_000_000L)).isZero()
    }

    @Test
    fun of_cameraWithoutTimeSinceBoot_doesNotCountDeepSleep() {
        for (source in listOf(CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_UNKNOWN, null)) {
            assertThat(PictureAge.of(source).micros(System.nanoTime() - 5_000_000L)).isBetween(5_000L, 60_000_000L)
        }
    }
}
