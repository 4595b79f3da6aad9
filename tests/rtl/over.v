// A sample over what lies behind it, SPEC.md, section 14: 4 multipliers, 10 adders. One sample a
// clock, 3 clocks late.
`default_nettype none

module over (
    input  wire        clock,
    input  wire [95:0] colours,       // E[c], below 2^31 + 2^22, in bits 32 c + 31 to 32 c
    input  wire [31:0] transmittance, // T, u32.31, at most 2^31
    input  wire [95:0] lights,        // L[c], likewise
    input  wire [31:0] a32,
    output wire [95:0] colours_new,
    output wire [31:0] transmittance_new
);
    wire [95:0] hidden, colours1, kept, half1, half2;
    wire [31:0] lost, transmittance1, transmittance2;
    genvar      c;

    delay #(.WIDTH(128)) delay_state (clock, {colours, transmittance}, {colours1, transmittance1});
    delay #(.WIDTH(96)) delay_half (clock, half1, half2);
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            // floor((L + 1) / 2), at most 2^31
            add #(.WIDTH(32)) halve (clock, {1'b0, lights[32*c+1 +: 31]}, {31'b0, lights[32*c]},
                half1[32*c +: 32]);
            hi hide (clock, colours[32*c +: 32], a32, hidden[32*c +: 32]);
            sub #(.WIDTH(32)) keep (clock, colours1[32*c +: 32], hidden[32*c +: 32],
                kept[32*c +: 32]);
            add #(.WIDTH(32)) adder (clock, kept[32*c +: 32], half2[32*c +: 32],
                colours_new[32*c +: 32]);
        end
    endgenerate
    hi loss (clock, transmittance, a32, lost);
    sub #(.WIDTH(32)) subtractor (clock, transmittance1, lost, transmittance2);
    delay #(.WIDTH(32)) delay_transmittance (clock, transmittance2, transmittance_new);
endmodule
