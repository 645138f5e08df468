package org.u2sa.android.sensor

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.data.Offset.offset
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

class OrientationTest {
    private val close = offset(1e-6)

    /** A turn of the phone about the vertical, counter-clockwise seen from above, as Android's sensor says it. */
    private fun turnedLeft(degrees: Double): FloatArray {
        val half = Math.toRadians(degrees) / 2.0
        return floatArrayOf(0f, 0f, sin(half).toFloat(), cos(half).toFloat(), 0.1f)
    }

    @ParameterizedTest
    @CsvSource("0, 0", "90, 270", "-90, 90", "180, 180", "-45, 45")
    fun attitude_flatPhoneTurned_headsTheOtherWayRound(leftDeg: Double, headingDeg: Double) {
        val attitude = orientation(turnedLeft(leftDeg)).attitude(Mounting.FLAT)

        assertThat(Math.toDegrees(attitude.psi)).isCloseTo(headingDeg, offset(1e-3))
        assertThat(attitude.theta).isCloseTo(0.0, close)
        assertThat(attitude.phi).isCloseTo(0.0, close)
    }

    @ParameterizedTest
    @CsvSource("-1", "0")
    fun of_headingAccuracyThatIsNone_isUnknown(accuracy: Float) {
        assertThat(orientation(floatArrayOf(0f, 0f, 0f, 1f, accuracy)).headingSigmaRad).isNull()
    }

    @Test
    fun attitude_topEdgeLifted_isNoseUp() {
        val lifted = Math.toRadians(20.0) // about the phone's x axis, to the right
        val attitude = orientation(floatArrayOf(sin(lifted / 2).toFloat(), 0f, 0f, cos(lifted / 2).toFloat()))
            .attitude(Mounting.FLAT)

        assertThat(attitude.theta).isCloseTo(lifted, close)
    }

    @Test
    fun attitude_leftEdgeLifted_isRightWingDown() {
        val lifted = Math.toRadians(15.0) // about the phone's y axis, forward
        val attitude = orientation(floatArrayOf(0f, sin(lifted / 2).toFloat(), 0f, cos(lifted / 2).toFloat()))
            .attitude(Mounting.FLAT)

        assertThat(attitude.phi).isCloseTo(lifted, close)
    }

    @Test
    fun attitude_uprightPhoneThatLooksNorth_headsNorthLevel() {
        val quarter = PI / 4.0 // a quarter turn about x: top edge up, screen to the south, camera to the north
        val attitude = orientation(floatArrayOf(sin(quarter).toFloat(), 0f, 0f, cos(quarter).toFloat()))
            .attitude(Mounting.UPRIGHT)

        assertThat(sin(attitude.psi)).isCloseTo(0.0, close)
        assertThat(cos(attitude.psi)).isCloseTo(1.0, close)
        assertThat(attitude.theta).isCloseTo(0.0, close)
        assertThat(attitude.phi).isCloseTo(0.0, close)
    }

    @Test
    fun mounting_each_isARightHandedSetOfAxes() {
        for (mounting in Mounting.entries) {
            val f = mounting.forward
            val r = mounting.right
            val down = org.u2sa.messages.frame.Point.of(
                f.y() * r.z() - f.z() * r.y(), f.z() * r.x() - f.x() * r.z(), f.x() * r.y() - f.y() * r.x(),
            )
            assertThat(down.distanceTo(mounting.down)).describedAs(mounting.name).isLessThan(1e-12)
        }
    }

    @Test
    fun of_threeValues_completesTheQuaternion() {
        val three = turnedLeft(-90.0).copyOf(3)

        assertThat(Math.toDegrees(orientation(three).attitude(Mounting.FLAT).psi)).isCloseTo(90.0, offset(1e-3))
        assertThat(orientation(three).headingSigmaRad).isNull()
        assertThat(orientation(turnedLeft(0.0)).headingSigmaRad).isCloseTo(0.1, close)
    }

    @Test
    fun of_noNumbers_isRefused() {
        assertThat(PhoneOrientation.of(0, floatArrayOf(Float.NaN, 0f, 0f, 1f))).isNull()
        assertThat(PhoneOrientation.of(0, floatArrayOf(0f, 0f))).isNull()
        assertThat(PhoneOrientation.of(0, floatArrayOf(0f, 0f, 0f, 0f))).isNull()
    }

    private fun orientation(values: FloatArray) = requireNotNull(PhoneOrientation.of(0, values))
}
