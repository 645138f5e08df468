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
            assertThat(age(source)).isEqualTo(5_000L)
        }
        assertThat(age(CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_REALTIME)).isEqualTo(3_600_005_000L)
    }

    /** Of a picture 5 ms before now, of a phone that slept for an hour, if stamped without the sleep. */
    private fun age(source: Int?) = PictureAge.of(source, { 3_601_000_000_000L }, { 1_000_000_000L }).micros(995_000_000L)
}
