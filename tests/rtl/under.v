// A sample under what lies in front of it, and whether the ray may end, SPEC.md, sections 14 and
// 15: 4 multipliers, 4 adders, 1 comparator. One sample a clock, 2 clocks late.
`default_nettype none

module under (
    input  wire        clock,
    input  wire [95:0] colours,       // E[c], below 2^31 + 2^22, in bits 32 c + 31 to 32 c
    input  wire [31:0] transmittance, // T, u32.31, at most 2^31
    input  wire [95:0] lights,        // L[c], likewise
    input  wire [31:0] a32,
    input  wire [15:0] threshold,     // of termination, u16.16
    output wire [95:0] colours_new,
    output wire [31:0] transmittance_new,
    output wire        ended
);
    wire [95:0] gained, colours1;
    wire [31:0] lost, transmittance1;
    wire [15:0] threshold2;
    genvar      c;

    delay #(.WIDTH(128)) delay_state (clock, {colours, transmittance}, {colours1, transmittance1});
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            hi gain (clock, lights[32*c +: 32], transmittance, gained[32*c +: 32]);
            add #(.WIDTH(32)) adder (clock, colours1[32*c +: 32], gained[32*c +: 32],
                colours_new[32*c +: 32]);
        end
    endgenerate
    hi loss (clock, transmittance, a32, lost);
    sub #(.WIDTH(32)) subtractor (clock, transmittance1, lost, transmittance_new);
    delay #(.WIDTH(16), .CLOCKS(2)) delay_threshold (clock, threshold, threshold2);
    assign ended = transmittance_new <= {1'b0, threshold2, 15'd0};
endmodule
