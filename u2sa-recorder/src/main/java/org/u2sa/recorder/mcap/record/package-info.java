/** Records of an MCAP file and their fields (MCAP specification, version 0). */
package org.u2sa.recorder.mcap.record;
