// The light of rays, sample by sample, front to back or back to front, SPEC.md, section 14.
//
// A step needs the result of the step before, so one ray alone could take a sample every RAYS
// clocks only, the latency of the step: 2 front to back, 3 back to front. So many rays share the
// unit instead: clock t brings a sample of ray t mod RAYS, and the state of each goes round through
// the pipeline. first says that the sample is its ray's first.
`default_nettype none

module march #(
    parameter BACK_TO_FRONT = 0
) (
    input  wire        clock,
    input  wire        first,
    input  wire [95:0] lights,       // L[c] in bits 32 c + 31 to 32 c
    input  wire [31:0] a32,
    input  wire [15:0] threshold,    // of termination, u16.16; only front to back
    output wire [95:0] colours,      // E[c] after the sample of RAYS clocks before
    output wire [31:0] transmittance, // T, likewise
    output wire        ended          // never back to front
);
    wire [95:0] colours_old = first ? 96'd0 : colours;
    wire [31:0] transmittance_old = first ? 32'h80000000 : transmittance;

    generate
        if (BACK_TO_FRONT) begin : backwards
            over step (clock, colours_old, transmittance_old, lights, a32, colours, transmittance);
            assign ended = 0;
        end else begin : forwards
            under step (clock, colours_old, transmittance_old, lights, a32, threshold, colours,
                transmittance, ended);
        end
    endgenerate
endmodule
